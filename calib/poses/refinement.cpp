#include "calib/poses/refinement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "calib/adjust/adjustment_covariance.h"
#include "calib/adjust/bundle_adjustment.h"
#include "calib/lens/lens_support.h"
#include "calib/poses/registration.h"
#include "calib/poses/residual_pattern.h"
#include "calib/work/formatted.h"

namespace lumi {
namespace {

std::vector<int> views_of_cameras(const Capture& capture) {
    std::vector<int> count(capture.cameras.size(), 0);
    for (const View& view : capture.views) ++count[static_cast<std::size_t>(view.camera_index)];
    return count;
}

/// The model a lens is adjusted with before its own is chosen.
LensForm first_form(LensPolicy policy, LensModel model) {
    switch (policy) {
        case LensPolicy::kAuto:
            return with_principal_point_held(LensModel::kRadial);
        case LensPolicy::kNamed:
            return with_principal_point_held(model);
        case LensPolicy::kFocalLength:
            return focal_length_alone(model);
        case LensPolicy::kGiven:
        case LensPolicy::kHeld:
            return all_held(model);
    }
    return all_held(model);
}

std::optional<std::size_t> choice_of_form(const LensChoice& choice, const LensForm& form) {
    for (std::size_t index = 0; index < choice.trials.size(); ++index)
        if (choice.trials[index].form == form) return index;
    return std::nullopt;
}

/// The adjustment's lenses: what each camera's form is, and the capture's cameras in its model.
class Refinement {
 public:
    Refinement(Capture& capture, LensPolicy policy, const PoseOptions& options, int threads,
               PoseEvidence& evidence, Progress& progress)
        : capture_(capture),
          policy_(policy),
          threads_(threads),
          evidence_(evidence),
          progress_(progress) {
        adjustment_.max_reprojection_error_px = options.max_reprojection_error_px;
        adjustment_.min_track_length = options.min_track_length;
        evidence_.lenses.assign(capture.cameras.size(), {});
        for (std::size_t camera = 0; camera < capture.cameras.size(); ++camera) {
            take(camera, first_form(policy, capture.cameras[camera].model),
                 capture.cameras[camera]);
        }
    }

    void run() {
        adjust_and_drop_weak_views();
        drop_unused_lenses();
        if (policy_ == LensPolicy::kAuto || policy_ == LensPolicy::kGiven) {
            choose_forms();
            adjust_bundle(capture_, adjustment(), progress_);
            if (hold_doubtful_principal_points()) {
                adjust_bundle(capture_, adjustment(), progress_);
            } else if (policy_ == LensPolicy::kAuto) {
                free_principal_points_that_look_like_zooms();
            }
        }
        std::optional<AdjustmentCovariance> covariance = stated_covariance();
        if (policy_ == LensPolicy::kAuto && covariance && drop_unsupported(*covariance)) {
            adjust_bundle(capture_, adjustment(), progress_);
            covariance = stated_covariance();
        }
        record(covariance);
    }

 private:
    void take(std::size_t camera, const LensForm& form, const Camera& lens) {
        evidence_.lenses[camera].form = form;
        capture_.cameras[camera] = in_model(lens, form.model);
    }

    [[nodiscard]] BundleAdjustmentOptions adjustment() const {
        BundleAdjustmentOptions adjustment = adjustment_;
        for (const LensEvidence& lens : evidence_.lenses) {
            adjustment.held_lens_parameters.push_back(lens.form.held);
        }
        return adjustment;
    }

    void adjust_and_drop_weak_views() {
        constexpr std::size_t kMinPointsOfView = 12;  // Twice what a pose needs in unknowns.
        adjust_bundle(capture_, adjustment(), progress_);
        const std::size_t views_before = capture_.views.size();
        drop_weak_views(capture_, kMinPointsOfView);
        if (capture_.views.size() != views_before) {
            adjust_bundle(capture_, adjustment(), progress_);
        }
    }

    /// Of a lens whose every view was dropped nothing is known.
    void drop_unused_lenses() {
        std::vector<LensEvidence> used;
        for (const std::size_t index : drop_unused_cameras(capture_)) {
            used.push_back(std::move(evidence_.lenses[index]));
        }
        evidence_.lenses = std::move(used);
    }

    void choose_forms() {
        for (std::size_t camera = 0; camera < capture_.cameras.size(); ++camera) {
            const Camera lens = capture_.cameras[camera];
            evidence_.lenses[camera].choice = select_lens(
                capture_, static_cast<int>(camera),
                policy_ == LensPolicy::kGiven ? forms_of_given_lens(lens.model) : every_lens_form(),
                adjustment(), {}, threads_, progress_);
            if (evidence_.lenses[camera].choice) {
                const LensTrial choice = evidence_.lenses[camera].choice->choice();
                take(camera, choice.form, choice.lens);
            } else if (policy_ == LensPolicy::kAuto) {
                // Too few views to hold some out: what two standard deviations leave of the usual.
                take(camera, with_principal_point_held(LensModel::kSimpleRadial), lens);
            }
        }
    }

    /// What each picture has of its own (a lens that its stabiliser moves, rows that were read one
    /// after the other) looks in a few of them as if all had it, and a principal point, which a
    /// turn of all cameras and a longer focal length nearly make up for, goes far to explain that.
    /// Where residuals keep such a shape though it was free, it goes back to the middle.
    bool hold_doubtful_principal_points() {
        if (!residual_pattern(capture_).is_suspicious()) return false;
        bool any = false;
        for (std::size_t camera = 0; camera < capture_.cameras.size(); ++camera) {
            LensEvidence& evidence = evidence_.lenses[camera];
            if (!evidence.choice || holds_principal_point(evidence.form)) continue;
            const auto held = choice_with_principal_point_held(*evidence.choice);
            if (!held) continue;
            const Eigen::Vector2d doubtful_px = principal_point_px(capture_.cameras[camera]);
            evidence.dropped.push_back(
                formatted("cx cy = %.4g %.4g, though pictures seem to have a middle each",
                          doubtful_px.x(), doubtful_px.y()));
            evidence.choice->chosen = *held;
            take(camera, evidence.choice->choice().form, evidence.choice->choice().lens);
            any = true;
        }
        return any;
    }

    /// A principal point off the middle that all pictures share looks like focal lengths that run
    /// along the path: residuals show it though views that were held out do not. Where they look so
    /// and no longer do once it is free, it is.
    void free_principal_points_that_look_like_zooms() {
        if (!residual_pattern(capture_).is_zoomed()) return;
        const Capture held = capture_;
        const std::vector<LensEvidence> evidence_of_held = evidence_.lenses;
        bool any = false;
        for (std::size_t camera = 0; camera < capture_.cameras.size(); ++camera) {
            LensEvidence& evidence = evidence_.lenses[camera];
            if (!evidence.choice || !holds_principal_point(evidence.form)) continue;
            const auto free = choice_of_form(*evidence.choice, all_free(evidence.form.model));
            if (!free) continue;
            evidence.choice->chosen = *free;
            take(camera, evidence.choice->choice().form, evidence.choice->choice().lens);
            any = true;
        }
        if (!any) return;
        adjust_bundle(capture_, adjustment(), progress_);
        const ResidualPattern pattern = residual_pattern(capture_);
        if (!pattern.is_zoomed() && !pattern.is_suspicious()) return;
        capture_ = held;
        evidence_.lenses = evidence_of_held;
    }

    /// As the observations tell, wider where what is left of them has a shape: errors that go
    /// through whole pictures move poses as independent ones do whose variance is so much larger
    /// (overdispersion: McCullagh and Nelder, Generalized Linear Models, 1989, section 4.5).
    [[nodiscard]] std::optional<AdjustmentCovariance> stated_covariance() const {
        std::optional<AdjustmentCovariance> covariance =
            adjustment_covariance(capture_, adjustment(), progress_);
        if (!covariance) return covariance;
        const double dispersion = std::max(1.0, residual_pattern(capture_).shutter_ratio);
        for (Matrix6& pose : covariance->poses) pose *= dispersion;
        for (Eigen::MatrixXd& lens : covariance->lenses) lens *= dispersion;
        for (double& jitter_px : covariance->jitter_px) jitter_px *= std::sqrt(dispersion);
        return covariance;
    }

    bool drop_unsupported(const AdjustmentCovariance& covariance) {
        bool any = false;
        for (std::size_t camera = 0; camera < capture_.cameras.size(); ++camera) {
            LensEvidence& evidence = evidence_.lenses[camera];
            const SupportedLens supported =
                supported_lens(capture_.cameras[camera], evidence.form, covariance.lenses[camera]);
            if (supported.form == evidence.form) continue;
            evidence.dropped.insert(evidence.dropped.end(), supported.dropped.begin(),
                                    supported.dropped.end());
            take(camera, supported.form, supported.start);
            any = true;
        }
        return any;
    }

    void record(const std::optional<AdjustmentCovariance>& covariance) {
        const std::vector<int> views = views_of_cameras(capture_);
        for (std::size_t camera = 0; camera < capture_.cameras.size(); ++camera) {
            evidence_.lenses[camera].views = views[camera];
        }
        if (!covariance) return;
        evidence_.noise_px = covariance->noise_px;
        for (std::size_t camera = 0; camera < capture_.cameras.size(); ++camera) {
            const Eigen::VectorXd variance = covariance->lenses[camera].diagonal();
            for (const double value : variance) {
                evidence_.lenses[camera].sigma.push_back(std::sqrt(std::max(0.0, value)));
            }
        }
        for (std::size_t view = 0; view < capture_.views.size(); ++view) {
            evidence_.views.push_back(uncertainty_of(capture_.views[view], covariance->poses[view],
                                                     covariance->jitter_px[view]));
        }
    }

    static ViewUncertainty uncertainty_of(const View& view, const Matrix6& covariance,
                                          double jitter_px) {
        // The centre is -R^T t: it moves by -R^T (dt + t x turn).
        const Eigen::Vector3d& t = view.cam_from_world.translation;
        Eigen::Matrix<double, 3, 6> by_pose;
        by_pose << 0, -t.z(), t.y(), 1, 0, 0, t.z(), 0, -t.x(), 0, 1, 0, -t.y(), t.x(), 0, 0, 0, 1;
        const double variance = (by_pose * covariance * by_pose.transpose()).trace();
        const double turn_variance = covariance.topLeftCorner<3, 3>().trace();
        return {view.name, jitter_px, std::sqrt(std::max(0.0, variance)),
                std::sqrt(std::max(0.0, turn_variance)) * 180.0 / std::numbers::pi};
    }

    Capture& capture_;
    LensPolicy policy_;
    int threads_;
    PoseEvidence& evidence_;
    Progress& progress_;
    BundleAdjustmentOptions adjustment_;
};

}  // namespace

LensPolicy lens_policy(bool is_given, const PoseOptions& options) {
    if (is_given) return options.refine_lens ? LensPolicy::kGiven : LensPolicy::kHeld;
    return options.lens_model == "auto" ? LensPolicy::kAuto : LensPolicy::kNamed;
}

void refine(Capture& capture, LensPolicy policy, const PoseOptions& options, int threads,
            PoseEvidence& evidence, Progress& progress) {
    Refinement(capture, policy, options, threads, evidence, progress).run();
}

}  // namespace lumi
