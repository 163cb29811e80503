#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace lumi {

/// The convex hull of unit directions, which is their Delaunay triangulation on the sphere: the
/// circumscribed cap of each triangle contains no other direction, and every direction is a vertex.
/// Triangles index `directions` and wind counter-clockwise seen from outside the sphere. Empty when
/// the directions lie in one plane. No two may be closer than 1e-7 radians.
[[nodiscard]] std::vector<std::array<int, 3>> spherical_triangulation(
    const std::vector<Eigen::Vector3d>& directions);

}  // namespace lumi
