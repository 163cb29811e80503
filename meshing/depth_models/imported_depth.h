#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// The file of the depth of view `index`, made elsewhere: in `folder`, by the view's name with the
/// first of the endings of depth_file.h that there is, in place of its extension or else after it.
/// `names` are those of all views: where others have the same stem, the whole name counts first,
/// and what two of them would share belongs to neither.
///
/// Throws Error: E-DEPTH-MISSING (no file for this view), E-DEPTH-SHARED.
[[nodiscard]] std::filesystem::path imported_depth_file(const std::vector<std::string>& names,
                                                        std::size_t index,
                                                        const std::filesystem::path& folder);
/// Of every view.
[[nodiscard]] std::vector<std::filesystem::path> imported_depth_files(
    const std::vector<std::string>& names, const std::filesystem::path& folder);

/// What such a file says, on its own raster: z along the optical axis in world units, of any size
/// in the aspect ratio of `camera`. `png_unit` is the depth of one level of a 16-bit PNG in world
/// units.
///
/// Throws Error: E-DEPTH-SIZE (another aspect ratio), E-DEPTH-VALUE (a negative depth: probably
/// another convention), E-DEPTH-FORMAT.
[[nodiscard]] FloatImage read_imported_depth(const std::filesystem::path& file,
                                             const Camera& camera, double png_unit);

/// The depth map of a view from such a file, which shows the view's own picture: as its pinhole
/// sees it. Unknown depth is 0 or NaN, and gets confidence 0; +infinity is inverse depth 0. A
/// smaller raster takes the nearest sample, so that no depth arises between two surfaces. Throws as
/// `read_imported_depth` does.
[[nodiscard]] DepthMap imported_depth(const DepthView& view, const std::filesystem::path& file,
                                      double png_unit = 0.001);

}  // namespace lumi
