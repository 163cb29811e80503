#pragma once

#include <Eigen/Core>
#include <optional>

#include "calib/capture/inverse_depth_warp.h"

namespace lumi {

/// The pixel of a picture of this size that a point falls into; empty behind the camera and outside
/// of the picture, which may be too far outside for integers.
[[nodiscard]] inline std::optional<Eigen::Vector2i> pixel_in_picture(
    const std::optional<WarpedPixel>& point, int width, int height) {
    if (!point) return std::nullopt;
    const Eigen::Vector2d& pixel = point->pixel;
    const bool is_inside =
        pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < width && pixel.y() < height;
    if (!is_inside) return std::nullopt;
    return Eigen::Vector2i(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
}

}  // namespace lumi
