#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/colmap/colmap_database.h"
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

}  // namespace lumi
