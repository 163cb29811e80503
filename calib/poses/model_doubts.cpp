#include "calib/poses/model_doubts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "calib/adjust/bundle_adjustment.h"
#include "calib/poses/explained_refusal.h"
#include "calib/poses/pair_agreement.h"
#include "calib/poses/pose_shift.h"
#include "calib/poses/residual_pattern.h"
#include "calib/poses/shutter_adjustment.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

/// Of noise alone the ratio is 1, and with three parameters for each of ten views beyond 2 once in
/// ten thousand captures; lens models that do not fit quite raise it a little.
constexpr double kSuspiciousRatio = 4.0;
/// Poses that another model of the same photographs moves farther are not known.
constexpr double kMaxShiftShare = 0.05;
constexpr double kMaxTurn_deg = 1.0;
/// Nobody shakes a camera by more while a frame is read out: then it is something else.
constexpr double kMaxSkewShare = 0.15;
/// Of all pairs: such that the model denies. Chance verifies no pair with so many
/// matches: even few of them say that things look alike.
constexpr double kMaxContradictedShare = 0.03;

template <class... Values>
std::string text(const char* format, Values... values) {
    std::array<char, 400> line{};
    std::snprintf(line.data(), line.size(), format, values...);
    return line.data();
}

Capture with_own_lenses(const Capture& capture) {
    Capture own = capture;
    own.cameras.clear();
    for (View& view : own.views) {
        own.cameras.push_back(camera_of(capture, view));
        view.camera_index = static_cast<int>(own.cameras.size()) - 1;
    }
    return own;
}

/// Largest over smallest focal length of views that shared a lens before.
double zoom_factor(const Capture& own, const Capture& shared) {
    double factor = 1.0;
    for (std::size_t lens = 0; lens < shared.cameras.size(); ++lens) {
        double least = std::numeric_limits<double>::infinity();
        double most = 0;
        for (std::size_t index = 0; index < own.views.size(); ++index) {
            if (shared.views[index].camera_index != static_cast<int>(lens)) continue;
            const double focal_px = focal_length_px(camera_of(own, own.views[index])).mean();
            least = std::min(least, focal_px);
            most = std::max(most, focal_px);
        }
        if (most > 0) factor = std::max(factor, most / least);
    }
    return factor;
}

/// Where nearly all that moves in the pictures is a turn, poses follow any small wrong.
void refuse_low_parallax(const MotionEvidence& motion) {
    constexpr double kMostShare = 0.7;
    if (motion.rotation_share() < kMostShare) return;
    refuse_capture(CaptureReason::kNoParallax,
                   text("the camera moved too little against its turning: most of what is seen in "
                        "%d of %d pairs of photographs moves as if it had only turned, and the "
                        "poses contradict themselves",
                        motion.rotation_pairs, motion.pairs));
}

void settle_contradictions(const MappingJob& job, const MatchedPhotographs& matched,
                           const Capture& refined) {
    const PairAgreement agreement =
        compare_with_pairs(refined, job.photographs, matched.photographs, matched.pairs);
    job.evidence.contradicted_share = agreement.contradicted_share;
    if (agreement.contradicted < 2 || agreement.contradicted_share <= kMaxContradictedShare) return;
    const std::string what = text(
        "the photographs contradict themselves: %d of %d pairs that match do not fit where "
        "the cameras would have to be",
        agreement.contradicted, agreement.pairs);
    refuse_low_parallax(matched.motion);
    refuse_explained(job, matched, CaptureReason::kRepeated,
                     what + "; things that look alike were taken for one another");
}

void settle_shutter(const MappingJob& job, const MatchedPhotographs& matched, const Capture& mapped,
                    const Capture& refined) {
    if (mapped.views.size() != refined.views.size()) return;
    Capture start = mapped;
    start.cameras = refined.cameras;
    for (std::size_t index = 0; index < start.views.size(); ++index) {
        start.views[index].camera_index = refined.views[index].camera_index;
    }
    const double limit_px = job.options.max_reprojection_error_px;
    const ShutterAdjustment shutter = adjust_for_shutter(start, limit_px, job.progress);
    const std::size_t observations = count_observations(mapped);
    if (!explains_better(truncated_cost_px2(refined, observations, limit_px), shutter.cost_px2,
                         shutter.parameters, observations)) {
        return;
    }
    const PoseShift shift = pose_shift(named_poses(refined), named_poses(shutter.capture));
    const std::string what =
        text("the pictures are skewed by about %.1f pixels from the first row to the last",
             shutter.skew_px);
    if (shift.position_share > kMaxShiftShare || shift.rotation_deg > kMaxTurn_deg) {
        refuse_low_parallax(matched.motion);
        const Camera& lens = refined.cameras.front();
        const bool is_a_shutter =
            shutter.skew_px <= kMaxSkewShare * std::max(lens.width_px, lens.height_px);
        if (!is_a_shutter) {
            settle_contradictions(job, matched, refined);
            refuse_explained(job, matched, CaptureReason::kUncertain,
                             "the photographs contradict the best model of where they were taken");
        }
        refuse_capture(CaptureReason::kShutter,
                       what + text(", which moves cameras by up to %.0f %% of their spread",
                                   100 * shift.position_share));
    }
    job.evidence.warnings.push_back(std::string(code_of(CaptureReason::kShutter)) + ": " + what +
                                    "; " + std::string(advice_for(CaptureReason::kShutter)));
}

}  // namespace

bool give_own_lenses(const MappingJob& job, Capture& mapped, const Capture& refined) {
    constexpr double kMinZoom = 1.01;
    if (job.lens_is_calibrated || mapped.views.size() != refined.views.size() ||
        mapped.cameras.size() == mapped.views.size() ||
        residual_pattern(refined).zoom_ratio <= kSuspiciousRatio) {
        return false;
    }
    Capture start = with_own_lenses(mapped);
    Capture own = start;
    BundleAdjustmentOptions options;
    options.max_reprojection_error_px = job.options.max_reprojection_error_px;
    options.min_track_length = job.options.min_track_length;
    adjust_bundle(own, options, job.progress);
    const std::size_t observations = count_observations(mapped);
    const double limit_px = job.options.max_reprojection_error_px;
    const int more_parameters = 2 * static_cast<int>(own.cameras.size() - mapped.cameras.size());
    const bool is_better = explains_better(truncated_cost_px2(refined, observations, limit_px),
                                           truncated_cost_px2(own, observations, limit_px),
                                           more_parameters, observations);
    const double factor = zoom_factor(own, mapped);
    if (!is_better || factor < kMinZoom) return false;
    mapped = std::move(start);
    job.evidence.warnings.push_back(
        std::string(code_of(CaptureReason::kZoom)) +
        text(": focal lengths differ by a factor of %.2f between photographs of one camera; each "
             "was given a lens of its own. Next time, ",
             factor) +
        std::string(advice_for(CaptureReason::kZoom)));
    return true;
}

void settle_doubts(const MappingJob& job, const MatchedPhotographs& matched, const Capture& mapped,
                   const Capture& refined) {
    job.evidence.residual_pattern = residual_pattern(refined);
    if (job.evidence.residual_pattern.shutter_ratio > kSuspiciousRatio) {
        settle_shutter(job, matched, mapped, refined);
    }
    settle_contradictions(job, matched, refined);
}

}  // namespace lumi
