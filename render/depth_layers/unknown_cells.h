#pragma once

#include <vector>

#include "render/depth_search/tiled_depth.h"
#include "render/lumigraph/lumigraph.h"
#include "render/surroundings/picture_cells.h"
#include "render/view_choice/depth_view_choice.h"

namespace lumi {

/// Marks the cells in which all views of one of the sets, asked for their depth (depth_layers.h),
/// may know nothing: unless each set has a view whose photograph holds all of the cell's rays from
/// infinity to before the nearest that the view shows. Somewhere on the way they meet its depth
/// mesh, which has no holes but where it reaches to infinity. `depths` are those of all views;
/// surfaces beyond `max_inverse_depth` in the eye are not drawn.
void mark_where_depth_may_be_unknown(const Lumigraph& lumigraph,
                                     const std::vector<TiledDepth>& depths,
                                     const std::vector<DepthViewSet>& sets, const Eye& eye,
                                     double max_inverse_depth, PictureCells& cells);

}  // namespace lumi
