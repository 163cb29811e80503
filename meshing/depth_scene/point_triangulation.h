#pragma once

#include <array>
#include <vector>

#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// Delaunay triangulation of the points' pixels (CGAL, exact predicates). Of several points at one
/// pixel the first is used.
struct PointTriangulation {
    std::vector<std::array<int, 3>> triangles;  ///< Indices of points.
    std::vector<std::vector<int>> rings;        ///< Of each point, its neighbours; maybe empty.
};
[[nodiscard]] PointTriangulation triangulate(const std::vector<SparsePoint>& points);

}  // namespace lumi
