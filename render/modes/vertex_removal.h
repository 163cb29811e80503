#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace lumi {

struct VertexRemovalOptions {
    double max_height_error = 0.0;  ///< Of the surface at vertices that are removed.
    double max_border_error = 0.0;  ///< Of the place of the surface's ends.
    /// While there are more triangles than enough, height errors up to so many times the error.
    std::size_t enough_triangles = 0;
    double max_relaxation = 1.0;
    /// Sides of this rectangle, from the origin, are kept as they are.
    Eigen::Vector2d frame = Eigen::Vector2d::Zero();
};

/// Leaves out vertices of a surface z(x, y) that the others tell within an error: half-edge
/// collapses (Hoppe 1996; Schroeder, Zarge, Lorensen 1992), each checked at every vertex that
/// has been left out so far and in the middle of the edges that go, small errors first. Triangles
/// keep their turn. Ends of the surface stay within their error of where they were.
///
/// `groups` gives the corners of triangles by kind, three each, clockwise with x to the right and y
/// up; vertices that two kinds share are kept. Vertices are not renumbered.
void remove_vertices(const std::vector<Eigen::Vector3f>& vertices,
                     const std::vector<std::vector<std::uint32_t>*>& groups,
                     const VertexRemovalOptions& options);

/// Vertices at the same place become the first of them; in `indices` of all groups.
void weld(const std::vector<Eigen::Vector3f>& vertices,
          const std::vector<std::vector<std::uint32_t>*>& groups);

}  // namespace lumi
