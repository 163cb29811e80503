#pragma once

#include <array>
#include <optional>

#include "calib/capture/camera.h"

namespace lumi {

/// A lens in the terms of a file that need not tell the size of its pictures. Angles lie between 0
/// and pi; one focal length or angle is there at least.
struct StatedLens {
    std::optional<double> focal_x_px;
    std::optional<double> focal_y_px;
    std::optional<double> angle_of_view_x_rad;  ///< Where there is no focal length in pixels.
    std::optional<double> angle_of_view_y_rad;
    std::optional<double> centre_x_px;  ///< Empty: the middle of the picture.
    std::optional<double> centre_y_px;
    bool is_fisheye = false;
    std::array<double, 5> distortion{};  ///< k1 k2 p1 p2 k3; of a fisheye k1 k2 k3 k4.

    friend bool operator==(const StatedLens&, const StatedLens&) = default;
};

/// The lens for pictures of this size: the simplest of COLMAP's models with two focal lengths that
/// holds the distortion. (Both sides of a working copy are rounded: one focal length could not
/// follow both.)
[[nodiscard]] Camera lens_for_size(const StatedLens& lens, int width_px, int height_px);

}  // namespace lumi
