#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/colmap/colmap_commands.h"
#include "calib/colmap/colmap_database.h"
#include "calib/features/sift.h"
#include "calib/poses/camera_groups.h"
#include "calib/poses/pose_stage.h"
#include "calib/poses/rotation_check.h"

namespace lumi {

/// What both halves of the work with COLMAP need.
struct MappingJob {
    const std::vector<Photograph>& photographs;
    const CameraGroups& groups;
    const PoseOptions& options;
    bool lens_is_calibrated = false;
    bool refine_lens = true;
    std::filesystem::path scratch_folder;
    int threads = 0;
    Progress& progress;
    PoseEvidence& evidence;  ///< Receives the calls and the rung that succeeded.
};

/// Photographs with their features and the pairs that were verified, in a COLMAP database.
struct MatchedPhotographs {
    std::filesystem::path database;
    std::vector<ColmapPhotograph> photographs;
    std::vector<VerifiedPair> pairs;
    MotionEvidence motion;
};

/// Features, matches by look, and COLMAP's geometric verification; `name` names the files. Throws
/// Error: E-POSES-NOPAIR (no pair has enough matches), E-COLMAP-...
[[nodiscard]] MatchedPhotographs match_and_verify(const MappingJob& job, const SiftOptions& sift,
                                                  const std::string& name);

/// The best of the models a mapper run left in `models`, by registered photographs, then by
/// points; with the photographs' own names. Empty when there is none.
struct BestModel {
    Capture capture;
    int models_found = 0;
};
[[nodiscard]] std::optional<BestModel> read_best_model(const std::filesystem::path& models,
                                                       const std::vector<Photograph>& photographs);

/// Runs COLMAP's mapper from strict to gentle until nearly all photographs are placed, and returns
/// the best model of all runs; empty when no run made one. The last rung matches again with more
/// features, and `matched` is then replaced. Throws Error (E-COLMAP-TIME) when no run made a model
/// and one of them had to be ended.
[[nodiscard]] std::optional<Capture> map_by_ladder(const MappingJob& job,
                                                   MatchedPhotographs& matched);

}  // namespace lumi
