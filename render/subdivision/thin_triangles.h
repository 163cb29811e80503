#pragma once

#include "render/depth_search/depth_search.h"
#include "render/frame/frame.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {

/// What is thin (thin_surfaces.h) as triangles to be drawn over all else, the farthest first, from
/// the views that see most of what the eye sees, each in its own photograph. Where one of them sees
/// the place, thin or not, those after it add nothing. What stands behind something seen is not
/// drawn. At most `most`, the largest; 0: any number.
[[nodiscard]] BlendTriangles thin_triangles(const Lumigraph& lumigraph, const SearchedViews& views,
                                            const Eye& eye, const DepthSearch& search,
                                            std::size_t most);

}  // namespace lumi
