#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/poses/pose_stage.h"

namespace lumi {

/// What COLMAP 3.8 makes of photographs without us, for comparison.
struct ColmapReconstruction {
    std::optional<Capture> capture;  ///< The best of its models; empty when it made none.
    std::vector<ColmapCall> calls;   ///< What each of its programs cost.
};

/// `feature_extractor`, `exhaustive_matcher` and `mapper` with COLMAP's defaults, without GPU; the
/// photographs share lenses as they do for estimate_poses(), and a given lens is kept when
/// `options.refine_lens` is off. `scratch_folder` is emptied and used. Throws Error (E-COLMAP-...).
[[nodiscard]] ColmapReconstruction reconstruct_with_colmap(
    const std::vector<Photograph>& photographs, const std::optional<Camera>& given_lens,
    const PoseOptions& options, const std::filesystem::path& scratch_folder, int threads,
    Progress& progress);

}  // namespace lumi
