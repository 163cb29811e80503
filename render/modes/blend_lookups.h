#pragma once

#include <array>
#include <cstddef>

#include "render/modes/blend_triangles.h"

namespace lumi {

/// Triangles sorted by how many photographs are looked up on them.
struct TrianglesByLookups {
    /// First those that look up one photograph, then those with two and with three. Photographs
    /// that are looked up come first at each vertex; weights of the others are 0.
    BlendTriangles triangles;
    /// How many indices belong to triangles with one, two and three.
    std::array<std::size_t, 3> index_counts{};
};

/// The same picture with fewer look-ups, which are most of what a blend costs: where one photograph
/// stands for two cameras of a face (meshes of a line name cameras twice) it is looked up once, and
/// one that has no weight on a triangle (most often because it does not see the point) not at all.
[[nodiscard]] TrianglesByLookups sorted_by_lookups(const BlendTriangles& triangles);

}  // namespace lumi
