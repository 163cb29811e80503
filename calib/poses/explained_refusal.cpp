#include "calib/poses/explained_refusal.h"

#include <algorithm>
#include <cmath>

#include "calib/pictures/image_io.h"
#include "calib/work/median.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

constexpr std::size_t kMinInliersOfPair = 15;

/// Pictures are judged at the size that the doctor looks at.
std::vector<PhotographQuality> qualities_of(const MappingJob& job, int longer_side_px) {
    std::vector<PhotographQuality> qualities(job.photographs.size());
    parallel_for(static_cast<int>(job.photographs.size()), job.threads, [&](int position) {
        job.progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(position);
        const Photograph& photograph = job.photographs[index];
        const double scale = std::min(1.0, static_cast<double>(longer_side_px) /
                                               std::max(photograph.width_px, photograph.height_px));
        const auto scaled = [&](int side) { return std::max(1, static_cast<int>(scale * side)); };
        const ColorImage picture = read_color_image(photograph.picture_path);
        qualities[index] =
            quality_of(resized(picture, scaled(photograph.width_px), scaled(photograph.height_px)));
        qualities[index].name = photograph.name;
    });
    return qualities;
}

bool spoils_matches(CaptureReason reason) {
    return reason == CaptureReason::kExposure || reason == CaptureReason::kNoise ||
           reason == CaptureReason::kTexture || reason == CaptureReason::kBlur ||
           reason == CaptureReason::kClutter;
}

}  // namespace

CaptureEvidence evidence_of(const MappingJob& job, const MatchedPhotographs& matched) {
    constexpr int kLongerSide_px = 800;
    CaptureEvidence evidence;
    evidence.width_px = 0;
    for (const Photograph& photograph : job.photographs) {
        evidence.width_px =
            std::max({evidence.width_px, photograph.width_px, photograph.height_px});
    }
    evidence.width_px = std::min(evidence.width_px, kLongerSide_px);
    evidence.photographs = qualities_of(job, kLongerSide_px);
    evidence.motion = matched.motion;
    evidence.focal_lengths_are_known = focal_lengths_are_known(job.groups);
    std::vector<const VerifiedPair*> pairs;
    for (const VerifiedPair& pair : matched.pairs) {
        if (pair.inliers.size() < kMinInliersOfPair) continue;
        evidence.pairs.push_back(pair_geometry_of(pair, matched.photographs, job.groups.cameras));
        pairs.push_back(&pair);
    }
    evidence.loops = follow_matches(matched.photographs, pairs);
    evidence.inlier_shares = matched.inlier_shares;
    return evidence;
}

void refuse_explained(const MappingJob& job, const MatchedPhotographs& matched,
                      CaptureReason fallback, const std::string& what) {
    const std::vector<Finding> findings = diagnose(evidence_of(job, matched));
    for (const Finding& finding : findings) {
        // A plane, or what looks like a turn, harms few captures; where one failed, it is the
        // likely cause.
        const bool is_likely = finding.severity >= Severity::kRisk ||
                               finding.reason == CaptureReason::kPlanar ||
                               finding.reason == CaptureReason::kNoParallax;
        if (is_likely && is_cause(finding.reason)) refuse_capture(finding.reason, finding.what);
    }
    for (const Finding& finding : findings) {
        if (finding.reason == CaptureReason::kFew) refuse_capture(finding.reason, finding.what);
    }
    refuse_capture(fallback, what);
}

void refuse_contradiction(const MappingJob& job, const MatchedPhotographs& matched,
                          CaptureReason fallback, const std::string& what) {
    // Matches by look that are true mostly agree with one motion. Where few do, the rest will have
    // let some pairs pass by chance.
    constexpr double kMinInlierShare = 0.6;
    const std::vector<Finding> findings = diagnose(evidence_of(job, matched));
    for (const Finding& finding : findings) {
        if (finding.severity >= Severity::kRisk && spoils_matches(finding.reason)) {
            refuse_capture(finding.reason, finding.what);
        }
    }
    const double usual_share = median_of(matched.inlier_shares, 1.0);
    if (usual_share < kMinInlierShare) {
        const int percent = static_cast<int>(std::lround(100 * usual_share));
        refuse_capture(CaptureReason::kClutter,
                       what + ", and only " + std::to_string(percent) +
                           " % of what looks alike in two photographs stands still between them");
    }
    // Who only walks ahead leaves focal length and distances to make up for each other: a model
    // that is bent by that denies its matches here and there.
    for (const Finding& finding : findings) {
        if (fallback == CaptureReason::kUncertain && finding.severity >= Severity::kRisk &&
            finding.reason == CaptureReason::kForward) {
            refuse_capture(finding.reason, what + "; " + finding.what);
        }
    }
    refuse_capture(fallback, what);
}

}  // namespace lumi
