#pragma once

#include <filesystem>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/work/progress.h"

namespace lumi {

/// Depth maps made elsewhere (imported_depth.h), of photographs as the lens bent them.
struct ImportedDepthMaps {
    std::filesystem::path folder;
    double png_unit = 0.001;  ///< World units a level of a 16-bit PNG stands for.
};

/// The later stages see straight pictures. Brings the depth map of each of these views onto its
/// straightened picture, in `folder`, and returns their files: each pixel gets the nearest sample,
/// and z as it is, since lens and pinhole look the same way. Where no lens bends, nothing is
/// written, and the files are the maps' own.
///
/// `pinholes`: of the views; `poses_folder`: of the poses stage, which knows their lenses. Throws
/// Error (E-DEPTH-MISSING, E-DEPTH-SHARED, E-DEPTH-SIZE, E-DEPTH-VALUE, E-DEPTH-FORMAT;
/// E-DEPTH-UNDISTORTED for a map of COLMAP's under a lens that bends).
[[nodiscard]] std::vector<std::filesystem::path> straighten_depth(
    const ImportedDepthMaps& imported, const Capture& pinholes,
    const std::filesystem::path& poses_folder, const std::filesystem::path& folder, int threads,
    Progress& progress);

}  // namespace lumi
