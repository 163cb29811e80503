#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace lumi {

/// A face of the convex hull of directions; that hull is the Delaunay triangulation of the sphere.
struct SphericalFace {
    std::array<int, 3> corners{};  ///< Indices of directions, counter-clockwise seen from outside.
    double cap_angle_rad = 0.0;    ///< Radius of the empty circle through the corners; beyond a
                                   ///< quarter turn the centre lies outside the hull.
};

/// Triangulates unit directions on their sphere (CGAL, exact predicates). Empty when fewer than
/// four directions span a volume.
[[nodiscard]] std::vector<SphericalFace> triangulate_sphere(
    const std::vector<Eigen::Vector3d>& directions);

}  // namespace lumi
