#include "meshing/exposure/color_match.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "calib/work/median.h"

namespace lumi {
namespace {

using Gains = std::array<double, 3>;  ///< Red, green and blue.

Gains gains_of(const std::vector<SharedColor>& shared) {
    Gains own{1, 1, 1};  // Not zero, where all is black.
    Gains other{1, 1, 1};
    for (const SharedColor& color : shared) {
        own[0] += color.own.r;
        own[1] += color.own.g;
        own[2] += color.own.b;
        other[0] += color.other.r;
        other[1] += color.other.g;
        other[2] += color.other.b;
    }
    return {own[0] / other[0], own[1] / other[1], own[2] / other[2]};
}

}  // namespace

Rgb8 ColorMatch::in_own_colors(const Rgb8& other) const {
    return {own_from_other[0][other.r], own_from_other[1][other.g], own_from_other[2][other.b]};
}

bool ColorMatch::is_same(const Rgb8& own, const Rgb8& other) const {
    return largest_difference(own, in_own_colors(other)) <= tolerance;
}

std::optional<ColorMatch> color_match(const std::vector<SharedColor>& shared) {
    constexpr std::size_t kLeastShared = 50;
    constexpr double kShareWithin = 0.9;
    constexpr int kLeastTolerance = 3;
    if (shared.size() < kLeastShared) return std::nullopt;
    const Gains gains = gains_of(shared);
    ColorMatch match;
    for (std::size_t channel = 0; channel < gains.size(); ++channel) {
        for (std::size_t level = 0; level < 256; ++level) {
            match.own_from_other[channel][level] = static_cast<std::uint8_t>(
                std::min(255.0, std::round(static_cast<double>(level) * gains[channel])));
        }
    }
    std::vector<double> differences;
    differences.reserve(shared.size());
    for (const SharedColor& color : shared) {
        differences.push_back(largest_difference(color.own, match.in_own_colors(color.other)));
    }
    match.tolerance = std::max(kLeastTolerance,
                               static_cast<int>(quantile_of(std::move(differences), kShareWithin)));
    return match;
}

ColorImage averaged(const ColorImage& picture) {
    ColorImage result = picture;
    cv::Mat matrix(result.height(), result.width(), CV_8UC3, result.pixels().data());
    cv::blur(matrix, matrix, {3, 3});
    return result;
}

}  // namespace lumi
