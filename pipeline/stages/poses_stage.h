#pragma once

#include <filesystem>
#include <optional>

#include "calib/poses/pose_stage.h"
#include "pipeline/workspace/done_marker.h"

namespace lumi {

/// How the poses stage comes by its poses.
struct PoseSource {
    std::filesystem::path imported_poses;  ///< Empty: estimated.
    std::optional<Camera> given_lens;
    PoseOptions options;
};

/// Working copies -> sparse/ (a COLMAP model with the lens as it is) and pinhole/ (undistorted
/// pictures and their model) in `folder`.
[[nodiscard]] StageEvidence run_poses_stage(const std::filesystem::path& ingest_folder,
                                            const PoseSource& source,
                                            const std::filesystem::path& folder, int threads,
                                            Progress& progress);

}  // namespace lumi
