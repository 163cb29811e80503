#include "pipeline/evaluate/gain_fit.h"

#include <algorithm>
#include <cmath>

#include "pipeline/evaluate/equal_sizes.h"
#include "pipeline/evaluate/image_metrics.h"

namespace lumi {
namespace {

std::array<double, 3> channels(const Rgb8& color) {
    return {static_cast<double>(color.r), static_cast<double>(color.g),
            static_cast<double>(color.b)};
}

/// Sums over covered pixels, per channel.
struct ChannelMoments {
    double count = 0.0;
    std::array<double, 3> drawn{};
    std::array<double, 3> truth{};
    std::array<double, 3> drawn_drawn{};
    std::array<double, 3> drawn_truth{};
    std::array<double, 3> truth_truth{};
};

ChannelMoments moments_of(const ColorImage& photograph, const ColorImage& rendering,
                          const GrayImage& coverage) {
    ChannelMoments sums;
    for (std::size_t i = 0; i < photograph.pixels().size(); ++i) {
        if (coverage.pixels()[i] == 0) continue;
        const auto truth = channels(photograph.pixels()[i]);
        const auto drawn = channels(rendering.pixels()[i]);
        sums.count += 1.0;
        for (std::size_t k = 0; k < 3; ++k) {
            sums.drawn[k] += drawn[k];
            sums.truth[k] += truth[k];
            sums.drawn_drawn[k] += drawn[k] * drawn[k];
            sums.drawn_truth[k] += drawn[k] * truth[k];
            sums.truth_truth[k] += truth[k] * truth[k];
        }
    }
    return sums;
}

}  // namespace

std::optional<GainFit> fit_gain(const ColorImage& photograph, const ColorImage& rendering,
                                const GrayImage& coverage) {
    expect_equal_sizes(photograph, rendering);
    expect_equal_sizes(photograph, coverage);
    const ChannelMoments sums = moments_of(photograph, rendering, coverage);
    if (sums.count == 0.0) return std::nullopt;
    GainFit fit;
    double mean_square = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double mean_drawn = sums.drawn[k] / sums.count;
        const double mean_truth = sums.truth[k] / sums.count;
        const double variance = sums.drawn_drawn[k] / sums.count - mean_drawn * mean_drawn;
        const double covariance = sums.drawn_truth[k] / sums.count - mean_drawn * mean_truth;
        const double truth_variance = sums.truth_truth[k] / sums.count - mean_truth * mean_truth;
        constexpr double kLeastVariance = 1e-6;  // Far below one 8-bit step.
        if (variance > kLeastVariance) fit.gain[k] = covariance / variance;
        fit.bias[k] = mean_truth - fit.gain[k] * mean_drawn;
        mean_square +=
            truth_variance - 2.0 * fit.gain[k] * covariance + fit.gain[k] * fit.gain[k] * variance;
    }
    fit.psnr_db = psnr_of_mean_square(std::max(0.0, mean_square / 3.0));
    return fit;
}

}  // namespace lumi
