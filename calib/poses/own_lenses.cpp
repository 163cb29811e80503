#include "calib/poses/own_lenses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "calib/adjust/bundle_adjustment.h"
#include "calib/doctor/capture_reason.h"
#include "calib/poses/firm_joints.h"
#include "calib/poses/incremental_mapping.h"
#include "calib/poses/model_check.h"
#include "calib/poses/pair_agreement.h"
#include "calib/poses/pose_shift.h"
#include "calib/poses/residual_pattern.h"
#include "calib/work/error.h"
#include "calib/work/formatted.h"

namespace lumi {
namespace {

/// Focusing alone changes focal lengths by a per cent or two.
constexpr double kMinZoom = 1.025;
/// What the refinement may still add to a zoom that mapping found; measured: 0.007.
constexpr double kMostRefined = 0.01;

/// Largest over smallest focal length of views that shared a lens before.
double zoom_factor(const Capture& own, const Capture& shared) {
    std::map<std::string, double> own_focal_px;
    for (const View& view : own.views) {
        own_focal_px[view.name] = focal_length_px(camera_of(own, view)).mean();
    }
    double factor = 1.0;
    for (int lens = 0; lens < static_cast<int>(shared.cameras.size()); ++lens) {
        double least = std::numeric_limits<double>::infinity();
        double most = 0;
        for (const View& view : shared.views) {
            const auto focal = own_focal_px.find(view.name);
            if (view.camera_index != lens || focal == own_focal_px.end()) continue;
            least = std::min(least, focal->second);
            most = std::max(most, focal->second);
        }
        if (most > 0) factor = std::max(factor, most / least);
    }
    return factor;
}

/// What a photograph saw, by its name and place in the picture, with the squared residual.
using SquaredResiduals = std::map<std::tuple<std::string, double, double>, double>;

SquaredResiduals squared_residuals_px2(const Capture& capture) {
    SquaredResiduals squares;
    for (const ScenePoint& point : capture.points) {
        for (const Observation& seen : point.track) {
            const View& view = capture.views[static_cast<std::size_t>(seen.view_index)];
            const auto pixel =
                project(camera_of(capture, view), view.cam_from_world * point.position_in_world);
            if (!pixel) continue;
            squares[{view.name, seen.pixel.x(), seen.pixel.y()}] =
                (*pixel - seen.pixel).squaredNorm();
        }
    }
    return squares;
}

/// What two models leave of the observations that both have.
struct SharedCosts {
    double shared_px2 = 0;
    double own_px2 = 0;

    SharedCosts(const Capture& shared, const Capture& own) {
        const SquaredResiduals of_own = squared_residuals_px2(own);
        for (const auto& [seen, square_px2] : squared_residuals_px2(shared)) {
            const auto same = of_own.find(seen);
            if (same == of_own.end()) continue;
            shared_px2 += square_px2;
            own_px2 += same->second;
        }
    }

    /// Each point counts once: errors within a track go together.
    [[nodiscard]] bool own_is_better(const Capture& shared, const Capture& own) const {
        constexpr int kParametersOfLens = 2;  // Focal length and one of distortion.
        const int more = kParametersOfLens * (static_cast<int>(own.cameras.size()) -
                                              static_cast<int>(shared.cameras.size()));
        return explains_better(shared_px2, own_px2, more, shared.points.size());
    }

    /// Own lenses are simple ones. Where the shared lens bends as they cannot (a fisheye), their
    /// focal lengths differ only to make up for that, and more is left.
    [[nodiscard]] bool own_is_much_worse() const {
        constexpr double kMuch = 1.5;
        return own_px2 > kMuch * shared_px2;
    }
};

/// Whether focal lengths of photographs that shared a lens differ by more than they are uncertain:
/// five standard deviations, root mean square, of points that count once each; where pictures are
/// too bright or too dark, features are displaced together, and three are common. Where they are
/// less certain than the smallest zoom asked for (a small subject, seen from afar), focal length
/// and distance make up for each other along a curve that linear standard deviations are too small
/// for, and nothing can be said.
bool focal_lengths_differ(const Capture& own, const PoseEvidence& evidence, const Capture& shared) {
    constexpr double kMinSquare = 25.0;
    const double observations_of_point =
        static_cast<double>(count_observations(own)) / static_cast<double>(own.points.size());
    std::map<std::string, int> shared_lens;
    for (const View& view : shared.views) shared_lens[view.name] = view.camera_index;
    struct Sums {
        double weight = 0, log_focal = 0, square = 0;
        double variance = 0;
        int count = 0;
    };
    std::map<int, Sums> sums;
    for (const View& view : own.views) {
        const auto lens = shared_lens.find(view.name);
        const auto index = static_cast<std::size_t>(view.camera_index);
        if (lens == shared_lens.end() || index >= evidence.lenses.size() ||
            evidence.lenses[index].sigma.empty() || !(evidence.lenses[index].sigma[0] > 0)) {
            continue;
        }
        const double focal_px = focal_length_px(own.cameras[index]).x();
        const double sigma = evidence.lenses[index].sigma[0] / focal_px;
        Sums& sum = sums[lens->second];
        sum.weight += 1 / (sigma * sigma);
        sum.log_focal += std::log(focal_px) / (sigma * sigma);
        sum.square += std::log(focal_px) * std::log(focal_px) / (sigma * sigma);
        sum.variance += sigma * sigma;
        ++sum.count;
    }
    double square = 0;
    int redundant = 0;
    for (const auto& [lens, sum] : sums) {
        if (sum.count < 2 || std::sqrt(sum.variance / sum.count) > kMinZoom - 1) continue;
        square += sum.square - sum.log_focal * sum.log_focal / sum.weight;
        redundant += sum.count - 1;
    }
    return redundant > 0 && square > kMinSquare * observations_of_point * redundant;
}

/// A capture that nothing is told of, small enough to be mapped twice; what contradicts itself is.
bool is_worth_asking(const MappingJob& job, const Capture& refined, bool is_contradicted) {
    constexpr std::size_t kMinViews = 4;
    constexpr std::size_t kMaxViews = 30;
    if (job.lens_is_calibrated || job.options.mapper != PoseProgram::kLumi ||
        refined.views.size() < kMinViews || refined.cameras.size() == refined.views.size()) {
        return false;
    }
    const bool is_guessed =
        std::any_of(job.groups.cameras.begin(), job.groups.cameras.end(),
                    [](const ColmapCamera& camera) { return !camera.focal_length_is_known; });
    return is_contradicted || (is_guessed && job.photographs.size() <= kMaxViews);
}

std::string warning_of(double factor) {
    return std::string(code_of(CaptureReason::kZoom)) +
           formatted(
               ": focal lengths differ by a factor of %.2f between photographs of one camera; "
               "each was given a lens of its own. Next time, ",
               factor) +
           std::string(advice_for(CaptureReason::kZoom));
}

/// Each photograph with a lens of its own.
MatchedPhotographs with_own_lenses(const MatchedPhotographs& matched, const CameraGroups& groups) {
    MatchedPhotographs own = without_features(matched);
    for (std::size_t index = 0; index < own.photographs.size(); ++index) {
        own.photographs[index].camera_index = groups.camera_of_photograph[index];
    }
    return own;
}

Capture refined_with(LensPolicy policy, const MappingJob& job, const Capture& mapped,
                     PoseEvidence& evidence) {
    Capture refined = mapped;
    refine(refined, policy, job.options, job.threads, evidence, job.progress);
    (void)check_model(refined, false);
    return refined;
}

/// The question of find_own_lenses, asked of one capture.
class ZoomQuestion {
 public:
    ZoomQuestion(const MappingJob& job, const MatchedPhotographs& matched, const Capture& shared)
        : job_(job), matched_(matched), shared_(shared) {}

    /// The answer of a model whose lenses are simple: to choose them takes longer than all else.
    [[nodiscard]] bool may_be_zoomed(const MappingJob& own_job, const Capture& mapped) const {
        constexpr double kMinFactor = kMinZoom - kMostRefined;
        if (zoom_factor(mapped, shared_) < kMinFactor) return false;
        PoseEvidence evidence;
        const Capture refined = refined_with(LensPolicy::kNamed, own_job, mapped, evidence);
        return tells(refined, evidence, kMinFactor);
    }

    /// Whether poses differ by more than they may be wrong, no pair denies them, and a zoom is
    /// told.
    [[nodiscard]] bool tells(const Capture& own, const PoseEvidence& evidence,
                             double min_factor) const {
        if (own.views.size() < shared_.views.size() || zoom_factor(own, shared_) < min_factor ||
            !pose_shift(named_poses(shared_), named_poses(own)).matters() ||
            compare_with_pairs(own, job_.photographs, matched_.photographs, matched_.pairs,
                               job_.progress)
                .is_contradiction()) {
            return false;
        }
        const SharedCosts costs(shared_, own);
        const auto explained = static_cast<double>(count_observations(shared_));
        const auto explained_by_own = static_cast<double>(count_observations(own));
        return ZoomEvidence{explained_by_own / explained - 1, costs.own_is_better(shared_, own),
                            costs.own_is_much_worse(), focal_lengths_differ(own, evidence, shared_)}
            .is_told();
    }

 private:
    const MappingJob& job_;
    const MatchedPhotographs& matched_;
    const Capture& shared_;
};

/// Empty where no model comes of it, or none that tells of a zoom.
std::optional<SecondModel> answer_of(const ZoomQuestion& question, const MappingJob& own_job,
                                     MatchedPhotographs own_matched, LensPolicy policy) {
    try {
        const std::optional<Capture> mapped = map_incrementally(own_job, own_matched);
        if (!mapped || !question.may_be_zoomed(own_job, *mapped)) return std::nullopt;
        JointCheck joints = with_firm_joints(own_job, *mapped);
        SecondModel model;
        model.refined = refined_with(policy, own_job, joints.mapped, own_job.evidence);
        model.mapped = std::move(joints.mapped);
        model.joint_trouble = std::move(joints.trouble);
        if (!question.tells(model.refined, own_job.evidence, kMinZoom)) return std::nullopt;
        return model;
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::kDegenerateCapture) throw;
        return std::nullopt;
    }
}

}  // namespace

bool ZoomEvidence::is_told() const {
    /// Zooms of 1.03 were seen to explain 1.6 and 3.1 % more, larger ones 9 % and more; groups of
    /// photographs that only seemed to be zoomed nothing, or up to 13 % less.
    constexpr double kLeastMore = 0.005;
    return leaves_less || (more_explained > kLeastMore && !leaves_more && is_certain);
}

std::optional<SecondModel> find_own_lenses(const MappingJob& job, const MatchedPhotographs& matched,
                                           LensPolicy policy, const Capture& refined) {
    const PairAgreement agreement = compare_with_pairs(
        refined, job.photographs, matched.photographs, matched.pairs, job.progress);
    if (!is_worth_asking(job, refined, agreement.is_contradiction())) return std::nullopt;

    const CameraGroups own_groups =
        group_cameras(job.photographs, std::nullopt,
                      {.lens_model = job.options.lens_model, .shared_lens = false});
    PoseEvidence evidence;
    const MappingJob own_job{.photographs = job.photographs,
                             .groups = own_groups,
                             .options = job.options,
                             .lens_is_calibrated = false,
                             .refine_lens = job.refine_lens,
                             .scratch_folder = job.scratch_folder,
                             .threads = job.threads,
                             .progress = job.progress,
                             .evidence = evidence};
    const ZoomQuestion question(job, matched, refined);
    std::optional<SecondModel> own =
        answer_of(question, own_job, with_own_lenses(matched, own_groups), policy);
    if (!own) return std::nullopt;
    tell_of_second_model(job.evidence, std::move(evidence));
    own->warning = warning_of(zoom_factor(own->refined, refined));
    return own;
}

}  // namespace lumi
