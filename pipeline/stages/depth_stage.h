#pragma once

#include <filesystem>

#include "meshing/depth/depth_stage.h"
#include "pipeline/stages/straightened_masks.h"
#include "pipeline/workspace/done_marker.h"

namespace lumi {

/// How the subject was told from the rest, as the stage's evidence says it ("subject", "from").
constexpr const char* kSubjectDrawn = "drawn masks";
constexpr const char* kSubjectBeforeBackground = "plain background";
/// Where straightened masks lie in the stage's folder.
constexpr const char* kMaskFolder = "masks";
/// And depth maps made elsewhere, where a lens bends.
constexpr const char* kImportedDepthFolder = "imported";

/// Pictures and poses of the views in use -> inverse depth and confidence of each in `folder`, and
/// the masks that were drawn over photographs, those of held-out ones among them (nothing else of
/// these is looked at).
[[nodiscard]] StageEvidence run_depth_stage(const PosedPhotographs& photographs,
                                            const MaskedPhotographs& masked, DepthOptions options,
                                            const std::filesystem::path& folder, int threads,
                                            Progress& progress);

}  // namespace lumi
