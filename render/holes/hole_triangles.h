#pragma once

#include "render/depth_search/searched_views.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/subdivision/adaptive_subdivision.h"
#include "render/surroundings/picture_cells.h"

namespace lumi {

/// What lies in the marked cells of the eye's picture, as triangles: those of the mode `adaptive`
/// there (adaptive_subdivision.h), with what a face's cameras do not see taken from the views next
/// to them (unseen_triangles.h). They cover the cells and nothing else. Corners without confidence
/// are guesses.
[[nodiscard]] BlendTriangles hole_triangles(const Lumigraph& lumigraph, const SearchedViews& views,
                                            const Eye& eye, const RenderOptions& options,
                                            const PictureCells& holes,
                                            AdaptiveSubdivider& subdivider);

}  // namespace lumi
