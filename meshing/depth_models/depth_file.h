#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// What a name of a depth map may end with in lower case, in the order in which files are looked
/// for: float TIFF (.tiff, .tif), OpenEXR (.exr: the channel Z, or Y, or the only one), PFM (.pfm),
/// 16-bit PNG (.png), and COLMAP's dense maps (.geometric.bin, .photometric.bin).
[[nodiscard]] const std::vector<std::string>& depth_file_endings();

/// Depth along the optical axis in world units, as the file has it: 0 or NaN where it is unknown. A
/// PNG holds multiples of `png_unit`. No negative depth is refused here, but by imported_depth.h.
///
/// Throws Error: E-DEPTH-FORMAT (not what its name says, or its header promises more than the file
/// holds), E-IMAGE-FORMAT, E-IMAGE-TRUNCATED, E-FILE-READ.
[[nodiscard]] FloatImage read_depth_file(const std::filesystem::path& path, double png_unit);

}  // namespace lumi
