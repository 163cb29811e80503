#include "render/depth_search/occlusion.h"

#include <algorithm>

namespace lumi {
namespace {

/// Over so many pixels a photograph fades in from its border.
constexpr double kFeather_px = 8.0;

}  // namespace

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
