#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "meshing/cameras/camera_star.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// Delaunay triangles on the sphere with a hole about `gap_direction`: the hull of the directions
/// and the gap's, without the triangles at the gap. Winds like spherical_triangulation. Empty when
/// the directions and the gap lie in one plane.
[[nodiscard]] std::vector<std::array<int, 3>> open_triangulation(
    const std::vector<Eigen::Vector3d>& directions, const Eigen::Vector3d& gap_direction);

/// Directed edges of the triangles that have no opposite edge, in the order of their first vertex.
[[nodiscard]] std::vector<std::array<int, 2>> border_edges(
    const std::vector<std::array<int, 3>>& faces);

/// Appends a skirt to the border of an open mesh whose vertices are the star's cameras: for each
/// border camera a virtual vertex of the same view, `length` (world units) away from it, outward
/// along the bisector of its border edges in the stereographic picture from the gap. There the
/// border is a convex polygon, so that the skirt's quadrilaterals do not overlap. Rays beyond the
/// capture are then extrapolated by the border's cameras, continuously.
void append_skirt(const CameraStar& star, const Eigen::Vector3d& gap_direction, double length,
                  CameraMesh& mesh);

}  // namespace lumi
