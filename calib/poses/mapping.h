#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/colmap/colmap_commands.h"
#include "calib/colmap/colmap_database.h"
#include "calib/colmap/match_list.h"
#include "calib/features/descriptor_matching.h"
#include "calib/features/features.h"
#include "calib/matching/camera_groups.h"
#include "calib/matching/rotation_check.h"
#include "calib/poses/pose_stage.h"

namespace lumi {

/// Matches by look that are more doubtful: geometry then decides which of them are right.
inline constexpr DescriptorMatchingOptions kLenientMatching{.max_ratio = 0.9, .max_angle_rad = 0.7};

/// What all steps from photographs to poses need.
struct MappingJob {
    const std::vector<Photograph>& photographs;
    const CameraGroups& groups;
    const PoseOptions& options;
    bool lens_is_calibrated = false;
    bool refine_lens = true;
    std::filesystem::path scratch_folder;
    int threads = 0;
    Progress& progress;
    PoseEvidence& evidence;  ///< Receives the calls and the start that succeeded.
};

/// The same job, told of elsewhere: whether its model is taken is decided later.
[[nodiscard]] inline MappingJob with_evidence(const MappingJob& job, PoseEvidence& evidence) {
    return {.photographs = job.photographs,
            .groups = job.groups,
            .options = job.options,
            .lens_is_calibrated = job.lens_is_calibrated,
            .refine_lens = job.refine_lens,
            .scratch_folder = job.scratch_folder,
            .threads = job.threads,
            .progress = job.progress,
            .evidence = evidence};
}

/// How many features are looked for.
enum class FeatureDetail {
    kUsual,  ///< As many as configured, of the usual contrast.
    kMore,   ///< Twice as many, down to half the contrast.
};

/// Photographs with their features and the pairs that were verified.
struct MatchedPhotographs {
    std::string name;  ///< Names the files.
    FeatureDetail detail = FeatureDetail::kUsual;
    std::filesystem::path database;  ///< COLMAP's, once there is one.
    std::vector<Features> features;  ///< With descriptors; empty when COLMAP found the features.
    std::vector<ColmapPhotograph> photographs;
    std::vector<VerifiedPair> pairs;
    MotionEvidence motion;
    /// Of pairs with enough matches by look to tell: the share of them that was verified.
    std::vector<double> inlier_shares;
};

/// Features, matches by look, and their geometric verification, by our own means or, with `[poses]
/// front_end = "colmap"`, by COLMAP's; with more features where the usual ones verify no pair.
/// Throws Error: E-POSES-NOPAIR (no pair has enough matches), E-POSES-TEXTURE (the same, and hardly
/// any features are there), E-COLMAP-...
[[nodiscard]] MatchedPhotographs match_and_verify(const MappingJob& job);

/// The same once more, named `name`, with more features than those of `matched`, by which `placed`
/// photographs were placed, and says so. Empty where these were more already, or where it fails
/// though that is a model: better than none.
[[nodiscard]] std::optional<MatchedPhotographs> match_more_features(
    const MappingJob& job, const MatchedPhotographs& matched, std::size_t placed,
    const std::string& name);

/// The same by COLMAP's own extractor and matcher, all photographs with all; the pairs are not
/// judged yet.
[[nodiscard]] MatchedPhotographs match_with_colmap_alone(const MappingJob& job,
                                                         FeatureDetail detail,
                                                         const std::string& name);

/// How COLMAP runs for this job.
[[nodiscard]] ColmapProgram colmap_of(const MappingJob& job);
void record(PoseEvidence& evidence, const ColmapRun& run);
/// Throws Error (E-COLMAP-TIME) unless COLMAP's `command` exited: a limit or a signal ended it.
void expect_ended(const ColmapRun& run, const MappingJob& job, const std::string& command);

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
/// features; where its model is taken, `matched` is replaced. Throws Error (E-COLMAP-TIME) when no
/// run made a model and one of them had to be ended.
[[nodiscard]] std::optional<Capture> map_by_ladder(const MappingJob& job,
                                                   MatchedPhotographs& matched);

/// Runs our own incremental mapper; then, while photographs are missing, with fewer matches asked
/// of each, with more lenient matches between the placed and the missing, and from more features
/// (`matched` is then replaced). Empty when no two photographs make a start.
[[nodiscard]] std::optional<Capture> map_incrementally(const MappingJob& job,
                                                       MatchedPhotographs& matched);

}  // namespace lumi
