#pragma once

#include <filesystem>

#include "calib/capture/camera.h"
#include "calib/work/progress.h"
#include "pipeline/workspace/done_marker.h"

namespace lumi {

/// Photographs of a calibration board -> the lens, in every format, with picture and figures.
[[nodiscard]] StageEvidence run_calibrate_stage(const std::filesystem::path& boards,
                                                const std::filesystem::path& folder, int threads,
                                                Progress& progress);

/// The lens that the stage left in its folder.
[[nodiscard]] Camera read_calibrated_lens(const std::filesystem::path& folder);

}  // namespace lumi
