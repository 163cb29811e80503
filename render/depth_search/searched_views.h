#pragma once

#include <vector>

#include "render/depth_mesh/thin_surfaces.h"
#include "render/depth_search/tiled_depth.h"
#include "render/depth_search/view_outlines.h"
#include "render/lumigraph/lumigraph.h"
#include "render/transfer/view_geometry.h"

namespace lumi {

/// The views of a Lumigraph as rays are looked for in them (depth_search.h).
struct SearchedViews {
    std::vector<ViewGeometry> geometries;
    std::vector<TiledDepth> depths;  ///< Their depth maps; empty where a view has none.
    std::vector<std::vector<OutlinePoint>> outlines;  ///< In them (view_outlines.h).
    /// Empty where they are not drawn (DrawingChoices::draws_thin).
    std::vector<ThinSurfaces> thin;
};

[[nodiscard]] SearchedViews searched_views(const Lumigraph& lumigraph);

/// What is thin in each view, whether it is drawn or not. Needs no photographs.
[[nodiscard]] std::vector<ThinSurfaces> thin_surfaces_of(
    const Lumigraph& lumigraph, const std::vector<ViewGeometry>& geometries);

}  // namespace lumi
