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
    std::vector<ThinSurfaces> thin;  ///< Where they are drawn (DrawingChoices::draws_thin).
};

[[nodiscard]] SearchedViews searched_views(const Lumigraph& lumigraph);

}  // namespace lumi
