#pragma once

#include <cstddef>
#include <vector>

#include "render/lumigraph/lumigraph.h"
#include "render/subdivision/blend_triangles.h"
#include "render/surroundings/empty_cells.h"

namespace lumi {

/// Triangles that one program draws.
struct LookupRun {
    std::size_t lookups = 1;    ///< Photographs on each, 1 to 3.
    bool may_show_none = true;  ///< Photographs may end on them, so that pixels stay empty.
    std::size_t index_count = 0;
};

/// Triangles sorted by how many photographs are looked up on them.
struct TrianglesByLookups {
    /// Run by run. Photographs that are looked up come first at each vertex; weights of the others
    /// are 0.
    BlendTriangles triangles;
    std::vector<LookupRun> runs;  ///< None of them empty.
};

/// The same picture with fewer look-ups, which are most of what a blend costs: where one photograph
/// stands for two cameras of a face (meshes of a line name cameras twice) it is looked up once, and
/// one that has no weight on a triangle (most often because it does not see the point) not at all.
/// `views` are those that the vertices name as layers; `border_px` is their unsure border.
[[nodiscard]] TrianglesByLookups sorted_by_lookups(const BlendTriangles& triangles,
                                                   const std::vector<LumigraphView>& views,
                                                   double border_px = kFinestBorder_px);

}  // namespace lumi
