#include "pipeline/evaluate/image_metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "calib/work/error.h"
#include "pipeline/evaluate/equal_sizes.h"

namespace lumi {
namespace {

constexpr int kWindow = 11;
constexpr double kSigma = 1.5;
constexpr double kPeak = 255.0;
constexpr double kC1 = (0.01 * kPeak) * (0.01 * kPeak);
constexpr double kC2 = (0.03 * kPeak) * (0.03 * kPeak);

double squared_difference(const Rgb8& a, const Rgb8& b) {
    const double r = static_cast<double>(a.r) - static_cast<double>(b.r);
    const double g = static_cast<double>(a.g) - static_cast<double>(b.g);
    const double blue = static_cast<double>(a.b) - static_cast<double>(b.b);
    return r * r + g * g + blue * blue;
}

std::array<double, kWindow> gaussian_window() {
    std::array<double, kWindow> window{};
    for (int i = 0; i < kWindow; ++i) {
        const double distance = i - kWindow / 2;
        window[static_cast<std::size_t>(i)] =
            std::exp(-distance * distance / (2.0 * kSigma * kSigma));
    }
    const double sum = std::accumulate(window.begin(), window.end(), 0.0);
    for (double& weight : window) weight /= sum;
    return window;
}

/// Gaussian mean around every pixel whose window lies in the picture: 10 pixels less each way.
Image<double> windowed_mean(const Image<double>& image) {
    static const std::array<double, kWindow> kWeights = gaussian_window();
    Image<double> rows(image.width() - kWindow + 1, image.height());
    for (int y = 0; y < rows.height(); ++y) {
        for (int x = 0; x < rows.width(); ++x) {
            rows(x, y) =
                std::inner_product(kWeights.begin(), kWeights.end(), image.row(y) + x, 0.0);
        }
    }
    Image<double> mean(rows.width(), image.height() - kWindow + 1);
    for (int y = 0; y < mean.height(); ++y) {
        for (int i = 0; i < kWindow; ++i) {
            const double weight = kWeights[static_cast<std::size_t>(i)];
            const double* source = rows.row(y + i);
            double* target = mean.row(y);
            for (int x = 0; x < mean.width(); ++x) target[x] += weight * source[x];
        }
    }
    return mean;
}

Image<double> product(const Image<double>& a, const Image<double>& b) {
    Image<double> result(a.width(), a.height());
    std::transform(a.pixels().begin(), a.pixels().end(), b.pixels().begin(),
                   result.pixels().begin(), std::multiplies<>());
    return result;
}

}  // namespace

double psnr_of_mean_square(double mean_square) {
    if (mean_square == 0.0) return kIdenticalPsnrDb;
    return std::min(kIdenticalPsnrDb, 10.0 * std::log10(kPeak * kPeak / mean_square));
}

double psnr_db(const ColorImage& a, const ColorImage& b) {
    expect_equal_sizes(a, b);
    const double sum =
        std::transform_reduce(a.pixels().begin(), a.pixels().end(), b.pixels().begin(), 0.0,
                              std::plus<>(), squared_difference);
    return psnr_of_mean_square(sum / (3.0 * static_cast<double>(a.pixels().size())));
}

std::optional<double> psnr_db(const ColorImage& a, const ColorImage& b, const GrayImage& coverage) {
    expect_equal_sizes(a, b);
    expect_equal_sizes(a, coverage);
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        if (coverage.pixels()[i] == 0) continue;
        sum += squared_difference(a.pixels()[i], b.pixels()[i]);
        ++count;
    }
    if (count == 0) return std::nullopt;
    return psnr_of_mean_square(sum / (3.0 * static_cast<double>(count)));
}

double covered_share(const GrayImage& coverage) {
    if (coverage.empty()) return 0.0;
    const auto uncovered = std::count(coverage.pixels().begin(), coverage.pixels().end(), 0);
    return 1.0 - static_cast<double>(uncovered) / static_cast<double>(coverage.pixels().size());
}

std::optional<double> covered_share(const GrayImage& coverage, const GrayImage& subject) {
    expect_equal_sizes(coverage, subject);
    std::size_t covered = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < subject.pixels().size(); ++i) {
        if (subject.pixels()[i] == 0) continue;
        if (coverage.pixels()[i] != 0) ++covered;
        ++count;
    }
    if (count == 0) return std::nullopt;
    return static_cast<double>(covered) / static_cast<double>(count);
}

Image<double> luma(const ColorImage& image) {
    Image<double> result(image.width(), image.height());
    std::transform(image.pixels().begin(), image.pixels().end(), result.pixels().begin(),
                   [](const Rgb8& color) {
                       return 0.299 * static_cast<double>(color.r) +
                              0.587 * static_cast<double>(color.g) +
                              0.114 * static_cast<double>(color.b);
                   });
    return result;
}

double structural_similarity(const ColorImage& a, const ColorImage& b) {
    expect_equal_sizes(a, b);
    if (std::min(a.width(), a.height()) < kWindow) {
        throw Error(ErrorKind::kBadInput, "E-EVAL-SIZE",
                    "a picture of " + size_text(a.width(), a.height()) +
                        " is too small for structural similarity",
                    "compare pictures of at least 11x11 pixels");
    }
    const Image<double> luma_a = luma(a);
    const Image<double> luma_b = luma(b);
    const Image<double> mean_a = windowed_mean(luma_a);
    const Image<double> mean_b = windowed_mean(luma_b);
    const Image<double> mean_aa = windowed_mean(product(luma_a, luma_a));
    const Image<double> mean_bb = windowed_mean(product(luma_b, luma_b));
    const Image<double> mean_ab = windowed_mean(product(luma_a, luma_b));

    double sum = 0.0;
    for (std::size_t i = 0; i < mean_a.pixels().size(); ++i) {
        const double ma = mean_a.pixels()[i];
        const double mb = mean_b.pixels()[i];
        const double variance_a = mean_aa.pixels()[i] - ma * ma;
        const double variance_b = mean_bb.pixels()[i] - mb * mb;
        const double covariance = mean_ab.pixels()[i] - ma * mb;
        sum += (2.0 * ma * mb + kC1) * (2.0 * covariance + kC2) /
               ((ma * ma + mb * mb + kC1) * (variance_a + variance_b + kC2));
    }
    return sum / static_cast<double>(mean_a.pixels().size());
}

}  // namespace lumi
