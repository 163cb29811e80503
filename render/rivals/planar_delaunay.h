#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace lumi {

/// The Delaunay triangulation of points in the plane (Bowyer 1981, Watson 1981): no point lies
/// within the circle through the corners of a triangle. Triangles turn left. Of points that
/// coincide the first counts; fewer than three, or all on a line, give nothing.
[[nodiscard]] std::vector<std::array<int, 3>> planar_delaunay(
    const std::vector<Eigen::Vector2d>& points);

}  // namespace lumi
