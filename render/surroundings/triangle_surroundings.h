#pragma once

#include "render/lumigraph/lumigraph.h"
#include "render/subdivision/blend_triangles.h"
#include "render/surroundings/empty_cells.h"
#include "render/surroundings/surroundings.h"

namespace lumi {

/// Gives vertices of triangles that may have pixels which no photograph shows (empty_cells.h) the
/// colours of the surroundings there, in one pass with the photographs: where triangles are larger
/// than the cells of the picture, colours vary as linearly as all else on them. `triangles` are
/// what the eye sees of the lumigraph; `small` as for `surrounding_colors`, `border_px` as for
/// `may_show_none`.
void set_surroundings(const Lumigraph& lumigraph, const SmallPhotographs& small, const Eye& eye,
                      BlendTriangles& triangles, double border_px = kFinestBorder_px);

}  // namespace lumi
