#pragma once

#include <filesystem>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/work/progress.h"

namespace lumi {

/// Resamples every photograph (bicubic) to a pinhole camera of its own size, principal point and
/// pixel shape, and moves the tracks along. The focal length is the shortest at which the
/// photograph fills the whole frame: no black border, and no more of the picture lost than that
/// takes; of fisheyes also what is farther than 80 degrees off the axis, and what would make the
/// middle less than half as fine. Photographs of a camera without distortion are not resampled:
/// their picture file is used as it is. The others are written into `folder` as 000001.png ..., by
/// view. Throws Error: E-LENS-FOLDS, E-PICTURE-SIZE when a picture is not of its camera's size.
[[nodiscard]] PosedPhotographs undistort(const Capture& capture,
                                         const std::vector<std::filesystem::path>& picture_paths,
                                         const std::filesystem::path& folder, int threads,
                                         Progress& progress);

}  // namespace lumi
