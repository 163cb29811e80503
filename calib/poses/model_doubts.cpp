#include "calib/poses/model_doubts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "calib/poses/explained_refusal.h"
#include "calib/poses/model_check.h"
#include "calib/poses/pair_agreement.h"
#include "calib/poses/pose_shift.h"
#include "calib/poses/residual_pattern.h"
#include "calib/poses/supposed_adjustment.h"
#include "calib/poses/walk_in_rounds.h"
#include "calib/work/error.h"
#include "calib/work/formatted.h"

namespace lumi {
namespace {

bool mostly_turned(const MotionEvidence& motion) {
    constexpr double kMostShare = 0.7;
    return motion.rotation_share() >= kMostShare;
}

[[noreturn]] void refuse_low_parallax(const MotionEvidence& motion, const std::string& besides) {
    refuse_capture(
        CaptureReason::kNoParallax,
        formatted("the camera moved too little against its turning: most of what is seen in "
                  "%d of %d pairs of photographs moves as if it had only turned, and ",
                  motion.rotation_pairs, motion.pairs) +
            besides + turntable_hint(motion));
}

void settle_parallax(const MatchedPhotographs& matched, const Capture& refined) {
    if (!lacks_parallax(matched.motion, refined)) return;
    refuse_low_parallax(matched.motion,
                        formatted("rays to the same point meet at %.1f degrees only",
                                  median_triangulation_angle_deg(refined)));
}

/// What explains residuals that have a shape, beside what the same start gives without it.
struct Explanation {
    Supposition supposition;
    SupposedAdjustment without;
    SupposedAdjustment with;

    [[nodiscard]] CaptureReason reason() const {
        return supposition == Supposition::kShifted ? CaptureReason::kShifted
                                                    : CaptureReason::kShutter;
    }
    [[nodiscard]] std::string text() const {
        if (supposition == Supposition::kTurning) {
            return formatted(
                "the pictures are skewed by about %.1f pixels from the first row to the last",
                with.effect_px);
        }
        // What all have in common may as well be turned cameras.
        return formatted(
            "the middle of the lens lies about %.1f pixels from the middle of the pictures%s",
            with.effect_px, with.is_mostly_common() ? "" : ", in each at another place");
    }
};

/// Empty where the residuals have no suspicious shape, or are explained as well without.
std::optional<Explanation> explanation_of(const MappingJob& job, const Capture& mapped,
                                          const Capture& refined) {
    if (!job.evidence.residual_pattern.is_suspicious() ||
        mapped.views.size() != refined.views.size()) {
        return std::nullopt;
    }
    Capture start = mapped;
    start.cameras = refined.cameras;
    for (std::size_t index = 0; index < start.views.size(); ++index) {
        start.views[index].camera_index = refined.views[index].camera_index;
    }
    job.progress.begin("asking whether the rows were taken at one moment", 0);
    const auto adjusted = [&](Supposition supposition) {
        return adjust_supposing(
            supposition, start,
            job.lens_is_calibrated ? SupposedLens::kHeld : SupposedLens::kMiddleHeld,
            job.options.max_reprojection_error_px, job.progress);
    };
    Explanation turning{Supposition::kTurning, adjusted(Supposition::kSteady),
                        adjusted(Supposition::kTurning)};
    if (!explains_better(turning.without.cost_px2, turning.with.cost_px2, turning.with.parameters,
                         turning.with.observations)) {
        return std::nullopt;
    }
    // A lens that sits elsewhere moves pictures much as a turn does, and the two have as many
    // parameters.
    job.progress.begin("asking whether the lens sat elsewhere in each picture", 0);
    Explanation shifted{Supposition::kShifted, turning.without, adjusted(Supposition::kShifted)};
    return shifted.with.cost_px2 < turning.with.cost_px2 ? shifted : turning;
}

/// A lens whose middle lies elsewhere shows what a camera that is turned would: that far, attitudes
/// are not known, and no residual tells.
void widen_rotations(std::vector<ViewUncertainty>& views, const SupposedAdjustment& shifted) {
    if (views.size() != shifted.capture.views.size()) return;
    for (std::size_t index = 0; index < views.size(); ++index) {
        const Camera& camera = camera_of(shifted.capture, shifted.capture.views[index]);
        const double turn_rad = std::atan(shifted.effect_px / focal_length_px(camera).mean());
        double& sigma_deg = views[index].rotation_sigma_deg;
        sigma_deg = std::hypot(sigma_deg, turn_rad * 180.0 / std::numbers::pi);
    }
}

void settle_explanation(const MappingJob& job, const MatchedPhotographs& matched,
                        const Explanation& explanation) {
    const PoseShift shift =
        pose_shift(named_poses(explanation.without.capture), named_poses(explanation.with.capture));
    // Where more is left than is explained, something else is at work, and what is made of the
    // explanation follows that. Poses that follow it far are not held by the photographs.
    constexpr double kFar = 3.0;
    const bool is_main_cause = explanation.with.cost_px2 < 0.5 * explanation.without.cost_px2;
    if (!is_main_cause && shift.exceeds(kFar)) {
        constexpr double kManyShare = 0.5;
        const std::string unheld = formatted(
            "another model of the same photographs moves cameras by %.0f %% of "
            "their spread",
            100 * shift.position_share);
        if (matched.motion.rotation_share() >= kManyShare) {
            refuse_low_parallax(matched.motion, unheld);
        }
        refuse_explained(job, matched, CaptureReason::kUncertain, unheld);
    }
    if (is_main_cause && shift.matters()) {
        refuse_capture(
            explanation.reason(),
            explanation.text() + formatted(", which moves cameras by up to %.0f %% of their spread",
                                           100 * shift.position_share));
    }
    if (explanation.supposition == Supposition::kShifted) {
        widen_rotations(job.evidence.views, explanation.with);
    }
    job.evidence.warnings.push_back(
        std::string(code_of(explanation.reason())) + ": " + explanation.text() +
        formatted(", and cameras may have been elsewhere by %.0f %% of their spread, or turned by "
                  "%.1f degrees; ",
                  100 * shift.position_share, shift.rotation_deg) +
        std::string(advice_for(explanation.reason())));
}

/// Which pairs the model denies; empty where only single matches do not fit.
std::string denied_pairs(const PairAgreement& agreement) {
    if (agreement.contradicted > 0)
        return formatted("%d of %d pairs", agreement.contradicted, agreement.pairs);
    if (agreement.doubtful_in_order > 0)
        return formatted("%d of %d pairs of photographs that follow each other",
                         agreement.doubtful_in_order, agreement.in_order);
    return {};
}

std::string text_of(const PairAgreement& agreement) {
    const double percent = 100 * (1 - agreement.agreeing_share);
    const std::string matches =
        percent < 0.5 ? "few of all matches" : formatted("%.0f %% of all matches", percent);
    const std::string pairs = denied_pairs(agreement);
    return "the photographs contradict themselves: " +
           (pairs.empty() ? matches : pairs + ", and " + matches + ",") +
           " do not fit where the cameras would have to be";
}

/// Few of them are chance.
void warn_of_lookalikes(const PairAgreement& agreement, PoseEvidence& evidence) {
    constexpr double kManyShare = 0.03;
    const int all = agreement.pairs + agreement.outweighed;
    if (agreement.outweighed <= kManyShare * all) return;
    evidence.warnings.push_back(
        std::string(code_of(CaptureReason::kRepeated)) +
        formatted(": things look alike: of %d pairs of photographs %d say otherwise, each "
                  "outweighed by chains of pairs with far more matches; look at the drawing",
                  all, agreement.outweighed));
}

}  // namespace

bool lacks_parallax(const MotionEvidence& motion, const Capture& model) {
    constexpr double kClearAngle_deg = 6.0;
    return mostly_turned(motion) && median_triangulation_angle_deg(model) < kClearAngle_deg;
}

void settle_doubts(const MappingJob& job, const MatchedPhotographs& matched, const Capture& mapped,
                   const Capture& refined) {
    const PairAgreement agreement = compare_with_pairs(
        refined, job.photographs, matched.photographs, matched.pairs, job.progress);
    job.evidence.contradicted_share = agreement.contradicted_share;
    job.evidence.residual_pattern = residual_pattern(refined);
    const std::optional<Explanation> explanation = explanation_of(job, mapped, refined);
    const bool is_contradicted = agreement.is_contradiction();
    if (mostly_turned(matched.motion) && (is_contradicted || explanation)) {
        refuse_low_parallax(matched.motion, "the poses contradict themselves");
    }
    settle_parallax(matched, refined);
    if (is_contradicted && agreement.is_mistaken()) {
        refuse_contradiction(
            job, matched, CaptureReason::kRepeated,
            text_of(agreement) + "; things that look alike were taken for one another");
    }
    if (const auto rounds = walk_in_rounds(refined, job.photographs)) {
        refuse_contradiction(job, matched, CaptureReason::kRepeated, rounds->text());
    }
    if (explanation) settle_explanation(job, matched, *explanation);
    if (is_contradicted) {
        refuse_contradiction(job, matched, CaptureReason::kUncertain, text_of(agreement));
    }
    warn_of_lookalikes(agreement, job.evidence);
}

}  // namespace lumi
