#include "pipeline/evaluate/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "pipeline/evaluate/equal_sizes.h"
#include "pipeline/evaluate/opponent_color.h"

namespace lumi {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr float kColorExponent = 0.7F;      // q_c
constexpr float kFeatureExponent = 0.5F;    // q_f
constexpr float kLargeErrorShare = 0.4F;    // p_c
constexpr float kLargeErrorStart = 0.95F;   // p_t
constexpr double kFeatureWidthDeg = 0.082;  // w: peak to trough of the edge detector

/// Opponent channels of a picture: luminance, red-green, blue-yellow.
using OpponentPicture = std::array<cv::Mat, 3>;

OpponentPicture opponent_picture(const ColorImage& image) {
    OpponentPicture picture;
    for (cv::Mat& channel : picture) channel.create(image.height(), image.width(), CV_32F);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const Color3 color = opponent_from_linear(linear_from_srgb(image(x, y)));
            for (std::size_t k = 0; k < 3; ++k) picture[k].at<float>(y, x) = color[k];
        }
    }
    return picture;
}

cv::Mat filtered(const cv::Mat& channel, const std::vector<float>& along_x,
                 const std::vector<float>& along_y) {
    cv::Mat result;
    cv::sepFilter2D(channel, result, CV_32F, along_x, along_y, cv::Point(-1, -1), 0.0,
                    cv::BORDER_REPLICATE);
    return result;
}

/// A contrast sensitivity function is a sum of Gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b) in two
/// dimensions; each is a product of two rows.
struct Gaussian {
    double a;
    double b;
};

std::vector<double> row_of(const Gaussian& gaussian, int radius, double pixels_per_degree) {
    std::vector<double> row;
    for (int i = -radius; i <= radius; ++i) {
        const double x_deg = i / pixels_per_degree;
        row.push_back(std::exp(-kPi * kPi * x_deg * x_deg / gaussian.b));
    }
    return row;
}

/// The channel as the eye resolves it; the weights of the whole filter sum to 1.
cv::Mat seen_through(const cv::Mat& channel, const std::vector<Gaussian>& sensitivity,
                     double pixels_per_degree) {
    constexpr double kWidestB = 0.04;
    const int radius = static_cast<int>(
        std::ceil(3.0 * std::sqrt(kWidestB / (2.0 * kPi * kPi)) * pixels_per_degree));
    double total = 0.0;
    std::vector<double> shares;
    std::vector<std::vector<float>> rows;
    for (const Gaussian& gaussian : sensitivity) {
        const std::vector<double> row = row_of(gaussian, radius, pixels_per_degree);
        const double sum = std::accumulate(row.begin(), row.end(), 0.0);
        shares.push_back(gaussian.a * std::sqrt(kPi / gaussian.b) * sum * sum);
        total += shares.back();
        std::vector<float> normalised(row.size());
        std::transform(row.begin(), row.end(), normalised.begin(),
                       [&](double weight) { return static_cast<float>(weight / sum); });
        rows.push_back(std::move(normalised));
    }
    cv::Mat result = cv::Mat::zeros(channel.size(), CV_32F);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        result += filtered(channel, rows[i], rows[i]) * (shares[i] / total);
    }
    return result;
}

/// What the eye resolves of a picture, in linear RGB within the unit cube, as Hunt-adjusted Lab.
std::vector<Color3> perceived_colors(const OpponentPicture& picture, double pixels_per_degree) {
    const OpponentPicture seen{
        seen_through(picture[0], {{1.0, 0.0047}}, pixels_per_degree),
        seen_through(picture[1], {{1.0, 0.0053}}, pixels_per_degree),
        seen_through(picture[2], {{34.1, 0.04}, {13.5, 0.025}}, pixels_per_degree)};
    std::vector<Color3> colors;
    colors.reserve(seen[0].total());
    for (int y = 0; y < seen[0].rows; ++y) {
        for (int x = 0; x < seen[0].cols; ++x) {
            colors.push_back(hunt_adjusted_lab(clamped(linear_from_opponent(
                {seen[0].at<float>(y, x), seen[1].at<float>(y, x), seen[2].at<float>(y, x)}))));
        }
    }
    return colors;
}

/// HyAB: city-block in lightness, Euclidean in the two chromatic axes.
float hyab(const Color3& a, const Color3& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

/// Large differences share the upper twentieth of the scale.
float redistributed(float difference, float largest) {
    const float power = std::pow(difference, kColorExponent);
    const float knee = kLargeErrorShare * largest;
    if (power < knee) return kLargeErrorStart / knee * power;
    return kLargeErrorStart + (power - knee) / (largest - knee) * (1.0F - kLargeErrorStart);
}

/// The largest difference of all: pure green against pure blue.
float largest_color_error() {
    const float difference =
        hyab(hunt_adjusted_lab({0.0F, 1.0F, 0.0F}), hunt_adjusted_lab({0.0F, 0.0F, 1.0F}));
    return std::pow(difference, kColorExponent);
}

/// Positive weights sum to 1, negative ones to -1.
std::vector<float> balanced(const std::vector<double>& weights) {
    double positive = 0.0;
    double negative = 0.0;
    for (const double weight : weights) (weight > 0.0 ? positive : negative) += std::abs(weight);
    std::vector<float> result;
    for (const double weight : weights) {
        result.push_back(static_cast<float>(weight / (weight > 0.0 ? positive : negative)));
    }
    return result;
}

struct FeatureRows {
    std::vector<float> edge;
    std::vector<float> point;
    std::vector<float> across;
};

/// First and second derivative of a Gaussian, and the Gaussian across.
FeatureRows feature_rows(double pixels_per_degree) {
    const double sigma_px = 0.5 * kFeatureWidthDeg * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma_px));
    std::vector<double> edge;
    std::vector<double> point;
    std::vector<double> across;
    for (int i = -radius; i <= radius; ++i) {
        const double x = i / sigma_px;
        const double gaussian = std::exp(-x * x / 2.0);
        edge.push_back(-i * gaussian);
        point.push_back((x * x - 1.0) * gaussian);
        across.push_back(gaussian);
    }
    const double sum = std::accumulate(across.begin(), across.end(), 0.0);
    FeatureRows rows{balanced(edge), balanced(point), {}};
    for (const double weight : across) rows.across.push_back(static_cast<float>(weight / sum));
    return rows;
}

cv::Mat strength(const cv::Mat& luminance, const std::vector<float>& along,
                 const std::vector<float>& across) {
    cv::Mat result;
    cv::magnitude(filtered(luminance, along, across), filtered(luminance, across, along), result);
    return result;
}

/// At each pixel the larger of the differences in edges and in points, 0 to 1 after the exponent.
cv::Mat feature_difference(const cv::Mat& reference, const cv::Mat& test,
                           double pixels_per_degree) {
    const FeatureRows rows = feature_rows(pixels_per_degree);
    const cv::Mat a = (reference + 16.0) / 116.0;
    const cv::Mat b = (test + 16.0) / 116.0;
    cv::Mat edges;
    cv::Mat points;
    cv::absdiff(strength(a, rows.edge, rows.across), strength(b, rows.edge, rows.across), edges);
    cv::absdiff(strength(a, rows.point, rows.across), strength(b, rows.point, rows.across), points);
    return cv::max(edges, points);
}

}  // namespace

FloatImage flip_error_map(const ColorImage& reference, const ColorImage& test,
                          double pixels_per_degree) {
    expect_equal_sizes(reference, test);
    FloatImage error(reference.width(), reference.height());
    if (error.empty()) return error;
    const OpponentPicture a = opponent_picture(reference);
    const OpponentPicture b = opponent_picture(test);
    const std::vector<Color3> colors_a = perceived_colors(a, pixels_per_degree);
    const std::vector<Color3> colors_b = perceived_colors(b, pixels_per_degree);
    const cv::Mat features = feature_difference(a[0], b[0], pixels_per_degree);
    const float largest = largest_color_error();
    for (std::size_t i = 0; i < error.pixels().size(); ++i) {
        const float color_error = redistributed(hyab(colors_a[i], colors_b[i]), largest);
        const float feature = features.ptr<float>()[i];  // The matrix is continuous.
        const float feature_error =
            std::pow(feature / std::numbers::sqrt2_v<float>, kFeatureExponent);
        error.pixels()[i] = std::pow(color_error, 1.0F - std::min(1.0F, feature_error));
    }
    return error;
}

double mean_error(const FloatImage& error_map) {
    if (error_map.empty()) return 0.0;
    return std::accumulate(error_map.pixels().begin(), error_map.pixels().end(), 0.0) /
           static_cast<double>(error_map.pixels().size());
}

std::optional<double> mean_error(const FloatImage& error_map, const GrayImage& coverage) {
    expect_equal_sizes(error_map, coverage);
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < error_map.pixels().size(); ++i) {
        if (coverage.pixels()[i] == 0) continue;
        sum += static_cast<double>(error_map.pixels()[i]);
        ++count;
    }
    if (count == 0) return std::nullopt;
    return sum / static_cast<double>(count);
}

}  // namespace lumi
