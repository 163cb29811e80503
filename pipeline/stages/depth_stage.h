#pragma once

#include <filesystem>

#include "meshing/depth/depth_stage.h"
#include "pipeline/workspace/done_marker.h"

namespace lumi {

/// Pictures and poses of the views in use -> inverse depth and confidence of each in `folder`.
[[nodiscard]] StageEvidence run_depth_stage(const PosedPhotographs& photographs,
                                            const DepthOptions& options,
                                            const std::filesystem::path& folder, int threads,
                                            Progress& progress);

}  // namespace lumi
