#pragma once

#include <Eigen/Core>
#include <vector>

namespace lumi {

/// The part of a convex polygon in which line . (x, y, 1) is not negative (Sutherland, Hodgman
/// 1974). A line of zeros keeps everything.
[[nodiscard]] std::vector<Eigen::Vector2d> clipped(const std::vector<Eigen::Vector2d>& corners,
                                                   const Eigen::Vector3d& line);

}  // namespace lumi
