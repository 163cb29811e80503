#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace lumi {

/// The distance of a place in a picture of this size from the nearest border, in pixels; negative
/// beyond it.
[[nodiscard]] inline double border_distance_px(const Eigen::Vector2d& pixel, int width_px,
                                               int height_px) {
    return std::min({pixel.x(), pixel.y(), width_px - pixel.x(), height_px - pixel.y()});
}

}  // namespace lumi
