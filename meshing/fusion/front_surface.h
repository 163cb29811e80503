#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meshing/fusion/surface_points.h"

namespace lumi {

/// Triangles through the points, by an advancing front over their Delaunay triangulation (Cohen-
/// Steiner and Da, "A greedy Delaunay-based surface reconstruction algorithm", 2004; CGAL's). No
/// edge is longer than a few spacings of its points: what no view saw stays open. Turned so that
/// the points' normals look out. Which of two equally good triangles is taken may differ from run
/// to run. Memory grows with the points: about 1.5 KiB each.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> front_surface(
    const std::vector<SurfacePoint>& points);

}  // namespace lumi
