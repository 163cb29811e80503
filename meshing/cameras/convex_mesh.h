#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "meshing/cameras/camera_star.h"

namespace lumi {

/// The convex camera mesh of the paper (section 3.1): what a star loses that may not dent.
struct ConvexShape {
    std::vector<char> on_hull;              ///< For each camera of the star: whether it is kept.
    std::vector<std::array<int, 3>> faces;  ///< Of the kept cameras, indices into the star.
    double rms_push_share = 0.0;  ///< How far the others would have to be pushed out instead, as a
    double largest_push_share = 0.0;  ///< share of their distance; root mean square over all.
};

/// The convex hull of the cameras' centres as seen from the star's centre. With an `apex`, a
/// direction in which the mesh stays open, the hull's side towards it is left out. Cameras that lie
/// within a face of the hull are kept, up to 1e-7 of its size, and triangulated as Delaunay does.
/// No faces when the cameras (and the apex) lie in one plane.
[[nodiscard]] ConvexShape convex_shape(const CameraStar& star,
                                       const std::optional<Eigen::Vector3d>& apex);

/// The same for a row, arc or ring in the plane that `normal` is perpendicular to: which cameras
/// stand on the convex chain, seen along the normal. A row stays open opposite to its cameras.
[[nodiscard]] std::vector<char> on_convex_chain(const CameraStar& star,
                                                const Eigen::Vector3d& normal, bool closed_ring);

}  // namespace lumi
