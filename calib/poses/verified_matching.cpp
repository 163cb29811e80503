#include "calib/poses/verified_matching.h"

#include <utility>

#include "calib/doctor/capture_reason.h"
#include "calib/matching/inlier_shares.h"
#include "calib/matching/pair_verification.h"
#include "calib/matching/photograph_matching.h"
#include "calib/poses/colmap_front_end.h"
#include "calib/poses/registration.h"
#include "calib/work/error.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

[[noreturn]] void refuse_unmatched(const std::vector<ColmapPhotograph>& photographs) {
    std::vector<std::size_t> counts;
    for (const ColmapPhotograph& photograph : photographs) {
        counts.push_back(photograph.keypoints_px.size());
    }
    const std::size_t features = median_of(std::move(counts));
    refuse_capture(features < kHardlyAnyFeatures ? CaptureReason::kTexture : CaptureReason::kNoPair,
                   "no two of the " + std::to_string(photographs.size()) +
                       " photographs show the same things (" + std::to_string(features) +
                       " features in the middle photograph)");
}

MatchedPhotographs match_by_ourselves(const MappingJob& job, FeatureDetail detail,
                                      const std::string& name) {
    SiftOptions sift{.max_features = job.options.max_features};
    if (detail == FeatureDetail::kMore) {
        sift.max_features *= 2;
        sift.contrast_threshold /= 2;
    }
    MatchedPhotographs result;
    result.name = name;
    result.features =
        detect_features(job.photographs, job.options.mask_folder, sift, job.threads, job.progress);
    for (std::size_t index = 0; index < result.features.size(); ++index) {
        ColmapPhotograph photograph{job.groups.camera_of_photograph[index], {}};
        for (const Keypoint& keypoint : result.features[index].keypoints) {
            photograph.keypoints_px.push_back(keypoint.pixel);
        }
        result.photographs.push_back(std::move(photograph));
    }
    const std::vector<PairMatches> matches =
        match_photographs(result.features, job.threads, job.progress);
    result.pairs = verify_pairs(matches, job.groups.cameras, result.photographs,
                                job.lens_is_calibrated, {}, job.threads, job.progress);
    result.inlier_shares = inlier_shares_of(matches, result.pairs);
    return result;
}

MatchedPhotographs matched_with(const MappingJob& job, FeatureDetail detail,
                                const std::string& name) {
    MatchedPhotographs result = job.options.front_end == PoseProgram::kColmap
                                    ? match_with_colmap_alone(job, detail, name)
                                    : match_by_ourselves(job, detail, name);
    result.detail = detail;
    return result;
}

/// Throws Error where no pair was verified.
MatchedPhotographs with_motion(const MappingJob& job, MatchedPhotographs matched) {
    if (matched.pairs.empty()) refuse_unmatched(matched.photographs);
    matched.motion = check_motion(job.groups.cameras, matched.photographs, matched.pairs,
                                  job.lens_is_calibrated, job.progress);
    return matched;
}

}  // namespace

MatchedPhotographs match_and_verify(const MappingJob& job) {
    MatchedPhotographs usual = matched_with(job, FeatureDetail::kUsual, "default");
    if (!usual.pairs.empty()) return with_motion(job, std::move(usual));
    job.progress.note("no two photographs show the same things: trying more features");
    return with_motion(job, matched_with(job, FeatureDetail::kMore, "more"));
}

std::optional<MatchedPhotographs> match_more_features(const MappingJob& job,
                                                      const MatchedPhotographs& matched,
                                                      std::size_t placed, const std::string& name) {
    if (matched.detail == FeatureDetail::kMore) return std::nullopt;
    job.progress.note("placed " + std::to_string(placed) + " of " +
                      std::to_string(job.photographs.size()) + ": trying more features");
    try {
        return with_motion(job, matched_with(job, FeatureDetail::kMore, name));
    } catch (const Error& error) {
        if (placed < 2 || error.kind() == ErrorKind::kInterrupted) throw;
        job.progress.note(std::string("more features could not be tried: ") + error.what() + " (" +
                          error.code() + ")");
        return std::nullopt;
    }
}

}  // namespace lumi
