#include "render/viewer/enlargement.h"

#include <algorithm>
#include <cmath>

namespace lumi {

Enlargement enlarged_about(const Enlargement& from, const Eigen::Vector2d& cursor_share,
                           double steps) {
    constexpr double kTimesPerStep = 1.25;
    constexpr double kMostTimes = 32.0;
    Enlargement to;
    to.times = std::clamp(from.times * std::pow(kTimesPerStep, steps), 1.0, kMostTimes);
    const double change = to.times / from.times;
    const Eigen::Vector2d corner = cursor_share + change * (from.corner - cursor_share);
    to.corner = corner.cwiseMax(1.0 - to.times).cwiseMin(0.0);
    return to;
}

}  // namespace lumi
