#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace lumi {

/// From a place in a picture of this size to its nearest border, in pixels; negative beyond it.
[[nodiscard]] inline double border_distance_px(const Eigen::Vector2d& pixel, int width_px,
                                               int height_px) {
    return std::min({pixel.x(), pixel.y(), width_px - pixel.x(), height_px - pixel.y()});
}

}  // namespace lumi
