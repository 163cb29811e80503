#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace lumi {

/// The triangles of the convex hull of the points, winding counter-clockwise seen from outside, in
/// ascending order, each beginning with its least index. Points within a face or an edge of the
/// hull are no corners; of equal points the first is. Empty when the points lie in one plane.
[[nodiscard]] std::vector<std::array<int, 3>> convex_hull_faces(
    const std::vector<Eigen::Vector3d>& points);

}  // namespace lumi
