#pragma once

#include <filesystem>

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Depth made elsewhere: z along the optical axis in world units, of the view's aspect ratio and
/// any size, found in `folder` by the view's name with one of the endings of depth_file.h in place
/// of, or after, its extension. Unknown depth is 0 or NaN, and gets confidence 0; +infinity is
/// inverse depth 0. A smaller raster takes the nearest sample, so that no depth arises between two
/// surfaces. `png_unit` is the depth of one level of a 16-bit PNG in world units.
///
/// Throws Error: E-DEPTH-MISSING (no file for this view), E-DEPTH-SIZE (another aspect ratio),
/// E-DEPTH-VALUE (a negative depth: probably another convention), E-DEPTH-FORMAT.
[[nodiscard]] DepthMap imported_depth(const DepthView& view, const std::filesystem::path& folder,
                                      double png_unit = 0.001);

}  // namespace lumi
