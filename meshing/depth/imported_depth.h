#pragma once

#include <filesystem>

#include "meshing/depth/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Depth made elsewhere: a float TIFF of z along the optical axis in world units, of the view's
/// aspect ratio and any size, found in `folder` by the view's name with ".tiff" or ".tif" in place
/// of, or after, its extension. Unknown depth is 0 or NaN, and gets confidence 0; +infinity is
/// inverse depth 0. A smaller raster takes the nearest sample, so that no depth arises between two
/// surfaces.
///
/// Throws Error: E-DEPTH-MISSING (no file for this view), E-DEPTH-SIZE (another aspect ratio),
/// E-DEPTH-VALUE (a negative depth: probably another convention).
[[nodiscard]] DepthMap imported_depth(const DepthView& view, const std::filesystem::path& folder);

}  // namespace lumi
