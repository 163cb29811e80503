#pragma once

#include <filesystem>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/work/progress.h"

namespace lumi {

/// Resamples every photograph to a pinhole camera of its own size and focal length (bicubic), and
/// moves the tracks along. Photographs of a camera without distortion are not resampled: their
/// picture file is used as it is. Pixels that no photograph pixel maps to are avoided by the
/// smallest zoom that fills the frame. Files are written into `folder`, named after
/// `picture_paths`.
[[nodiscard]] PosedPhotographs undistort(const Capture& capture,
                                         const std::vector<std::filesystem::path>& picture_paths,
                                         const std::filesystem::path& folder, int threads,
                                         Progress& progress);

}  // namespace lumi
