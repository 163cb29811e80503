#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/ingest/ingest.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// The held-out photographs of a workspace at the size of other working copies, with the poses and
/// the lens of that workspace, undistorted into `scratch_folder`. Variants whose photographs differ
/// in size are thus measured against the same pixels: what is lost by a smaller size counts.
/// Throws Error (E-EVAL-NOPOSE, E-EVAL-NOHOLDOUT, E-CHART-SHAPE).
[[nodiscard]] PosedPhotographs reference_photographs(
    const WorkspaceLayout& workspace, const std::vector<Photograph>& reference_copies,
    const std::filesystem::path& scratch_folder, int threads, Progress& progress);

}  // namespace lumi
