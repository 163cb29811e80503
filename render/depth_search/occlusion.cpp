#include "render/depth_search/occlusion.h"

#include <algorithm>
#include <cstddef>

namespace lumi {
namespace {

/// Over so many pixels a photograph fades in from its border.
constexpr double kFeather_px = 8.0;

}  // namespace

std::array<double, 3> redistributed_by_the_paper(const std::array<double, 3>& weights,
                                                 const std::array<bool, 3>& is_seen) {
    std::array<double, 3> result{};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        if (is_seen[i]) sum += weights[i];
    const auto seen = static_cast<double>(std::count(is_seen.begin(), is_seen.end(), true));
    for (std::size_t i = 0; i < 3; ++i)
        if (is_seen[i]) result[i] = sum > 0 ? weights[i] / sum : 1 / seen;
    return result;
}

std::optional<std::array<double, 3>> redistributed(const std::array<double, 3>& weights,
                                                   const std::array<double, 3>& visibility) {
    std::array<double, 3> result{};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = weights[i] * visibility[i];
        sum += result[i];
    }
    if (sum < kLeastWeight) return std::nullopt;
    for (double& weight : result) weight /= sum;
    return result;
}

double occluded_share(const std::array<double, 3>& weights,
                      const std::array<double, 3>& visibility) {
    double lost = 1;
    for (std::size_t i = 0; i < 3; ++i) lost -= weights[i] * visibility[i];
    return lost;
}

double visibility_of(double difference_px, double tolerance_px) {
    return std::clamp(2 - difference_px / tolerance_px, 0.0, 1.0);
}

double border_fade(double distance_px) { return std::clamp(distance_px / kFeather_px, 0.0, 1.0); }

}  // namespace lumi
