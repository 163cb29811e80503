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
/// border camera a virtual vertex of the same view, `length` (world units) away from it. Rays
/// beyond the capture are then extrapolated by the border's cameras, continuously.
///
/// A virtual vertex lies between the meridian towards the gap, by which the skirt is star-shaped
/// about the centre whatever the border, and the bisector of the border's edges in the
/// stereographic picture from the gap, where the border is a convex polygon: steeper to jagged
/// borders of patches, but it may fold where the border nearly surrounds the scene. Of five shares
/// the one that leaves the scene (or, when nothing is known of it, a ball about the centre) the
/// most room is taken.
void append_skirt(const CameraStar& star, const Eigen::Vector3d& gap_direction, double length,
                  const std::vector<Eigen::Vector3d>& scene_hull_in_world, CameraMesh& mesh);

}  // namespace lumi
