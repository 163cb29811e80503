#include "calib/doctor/photograph_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "calib/capture/gray.h"
#include "calib/pictures/srgb_curve.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

/// Of the quieter third of blocks: there is little but noise.
double noise_sigma_of(const cv::Mat& gray) {
    const cv::Mat filter = (cv::Mat_<float>(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
    constexpr double kGain = 6.0;  // Root of the sum of its squares.
    constexpr int kBlock = 16;
    constexpr double kQuiet = 0.3;
    cv::Mat response;
    cv::filter2D(gray, response, CV_32F, filter);
    std::vector<float> of_blocks;
    for (int top = 0; top + kBlock <= gray.rows; top += kBlock) {
        for (int left = 0; left + kBlock <= gray.cols; left += kBlock) {
            std::vector<float> values;
            double brightness = 0;
            for (int y = top; y < top + kBlock; ++y) {
                for (int x = left; x < left + kBlock; ++x) {
                    values.push_back(std::abs(response.at<float>(y, x)));
                    brightness += static_cast<double>(gray.at<float>(y, x));
                }
            }
            brightness /= kBlock * kBlock;
            // Where the sensor is at its end, noise is cut off.
            if (brightness < 8 || brightness > 247) continue;
            const auto median = static_cast<double>(quantile_of(std::move(values), 0.5));
            of_blocks.push_back(static_cast<float>(median * kSigmaPerMedianOff / kGain));
        }
    }
    return static_cast<double>(quantile_of(std::move(of_blocks), kQuiet));
}

double standard_deviation(const cv::Mat& values) {
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(values, mean, deviation);
    return deviation[0];
}

/// What is left of white noise of standard deviation 1 between two Gaussians.
double noise_between(double fine_sigma, double coarse_sigma) {
    const auto variance = [](double a, double b) { return 1.0 / (2.0 * CV_PI * (a * a + b * b)); };
    return std::sqrt(std::max(0.0, variance(fine_sigma, fine_sigma) +
                                       variance(coarse_sigma, coarse_sigma) -
                                       2.0 * variance(fine_sigma, coarse_sigma)));
}

/// Share of the contrast between Gaussians of `fine_px` and twice that which a blur leaves, where
/// the power of the sharp picture falls with the square of the frequency: each difference of
/// Gaussians then holds the integral of (exp(-A w^2) - 2 exp(-B w^2) + exp(-C w^2)) / w, which is
/// half the logarithm of B^2 / (A C).
double surviving(double blur_px, double fine_px) {
    const auto power = [&](double blur_square) {
        const double square = fine_px * fine_px;
        const double middle = 2.5 * square + blur_square;
        return std::log(middle * middle / ((square + blur_square) * (4.0 * square + blur_square)));
    };
    return std::sqrt(power(blur_px * blur_px) / power(0.0));
}

/// Least squares over the logarithms of how detail falls off from the coarsest band; a sharp
/// picture is equal at all scales. Below its floor a band tells only that not more is there.
double blur_sigma_of(const PhotographQuality& quality, const std::array<double, 4>& floors) {
    constexpr std::size_t kCoarsest = 3;
    const double coarsest = std::max(quality.detail[kCoarsest], floors[kCoarsest]);
    double best_blur = 0.0;
    double best_cost = std::numeric_limits<double>::infinity();
    for (double blur_px = 0.0; blur_px <= 16.0; blur_px += 0.25) {
        double cost = 0;
        for (std::size_t band = 0; band < kCoarsest; ++band) {
            const double expected = coarsest * surviving(blur_px, std::exp2(band)) /
                                    surviving(blur_px, std::exp2(kCoarsest));
            const bool is_at_floor = quality.detail[band] <= floors[band];
            if (is_at_floor && expected <= floors[band]) continue;
            const double seen = std::max(quality.detail[band], floors[band]);
            const double difference = std::log(seen / std::max(expected, 1e-6));
            cost += difference * difference;
        }
        if (cost < best_cost) {
            best_cost = cost;
            best_blur = blur_px;
        }
    }
    return best_blur;
}

}  // namespace

double PhotographQuality::contrast() const {
    return *std::max_element(detail.begin(), detail.end());
}

PhotographQuality quality_of(const ColorImage& picture) {
    PhotographQuality quality;
    quality.longer_side_px = std::max(picture.width(), picture.height());
    const GrayImage levels = gray_of(picture);
    if (levels.empty()) return quality;
    const cv::Mat bytes(levels.height(), levels.width(), CV_8UC1,
                        const_cast<std::uint8_t*>(levels.pixels().data()));
    cv::Mat gray;
    bytes.convertTo(gray, CV_32F);
    std::size_t clipped = 0;
    for (const std::uint8_t level : levels.pixels()) {
        quality.mean_linear += light_of_srgb(level / 255.0);
        if (level <= 2 || level >= 253) ++clipped;
    }
    const double count = static_cast<double>(levels.pixels().size());
    quality.mean_linear /= count;
    quality.clipped_share = static_cast<double>(clipped) / count;
    quality.noise_sigma = noise_sigma_of(gray);

    // The noise is known to a third, and levels are rounded.
    std::array<double, 4> floors{};
    cv::Mat fine;
    cv::GaussianBlur(gray, fine, {}, 1.0);
    for (std::size_t band = 0; band < 4; ++band) {
        const double fine_px = std::exp2(band);
        cv::Mat coarse;
        cv::GaussianBlur(gray, coarse, {}, 2.0 * fine_px);
        const double seen = standard_deviation(fine - coarse);
        const double noise = quality.noise_sigma * noise_between(fine_px, 2.0 * fine_px);
        floors[band] = 0.8 * noise + 0.05;
        quality.detail[band] = std::sqrt(std::max(0.0, seen * seen - noise * noise));
        if (noise > 0) {
            quality.signal_to_noise =
                std::max(quality.signal_to_noise, quality.detail[band] / noise);
        }
        fine = coarse;
    }
    quality.blur_sigma_px = blur_sigma_of(quality, floors);
    return quality;
}

}  // namespace lumi
