#pragma once

#include "render/depth_search/depth_search.h"
#include "render/frame/frame.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {

/// What is thin (thin_surfaces.h) as triangles to be drawn over all else, the farthest first: that
/// of the views that see most of what the eye sees, each in its own photograph. What one of them
/// sees, those after it do not show again, and neither what it sees nothing of. Where something
/// stands before it, nothing is drawn. No more than `most`, the largest; 0: any number.
[[nodiscard]] BlendTriangles thin_triangles(const Lumigraph& lumigraph, const SearchedViews& views,
                                            const Eye& eye, const DepthSearch& search,
                                            std::size_t most);

}  // namespace lumi
