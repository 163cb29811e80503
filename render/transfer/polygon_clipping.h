#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "calib/capture/camera.h"

namespace lumi {

/// The corners of a camera's picture.
[[nodiscard]] std::vector<Eigen::Vector2d> picture_corners_px(const Camera& camera);

/// The part of a convex polygon in which line . (x, y, 1) is not negative (Sutherland, Hodgman
/// 1974). A line of zeros keeps everything.
[[nodiscard]] std::vector<Eigen::Vector2d> clipped(const std::vector<Eigen::Vector2d>& corners,
                                                   const Eigen::Vector3d& line);

/// The part from `low` to `high` along an axis.
[[nodiscard]] std::vector<Eigen::Vector2d> clipped_between(
    const std::vector<Eigen::Vector2d>& corners, Eigen::Index axis, double low, double high);

/// The part that lies in a box.
[[nodiscard]] std::vector<Eigen::Vector2d> clipped(const std::vector<Eigen::Vector2d>& corners,
                                                   const Eigen::AlignedBox2d& box);

}  // namespace lumi
