#include "calib/poses/refinement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "calib/adjust/adjustment_covariance.h"
#include "calib/adjust/bundle_adjustment.h"
#include "calib/lens/lens_support.h"
#include "calib/poses/registration.h"

namespace lumi {
namespace {

/// Ghosts begin to show where surfaces of two photographs are blended that far apart.
constexpr double kMaxJitter_px = 0.3;

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
        case LensPolicy::kGiven:
        case LensPolicy::kHeld:
            return all_held(model);
    }
    return all_held(model);
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
        if (policy_ == LensPolicy::kAuto || policy_ == LensPolicy::kGiven) {
            choose_forms();
            adjust_bundle(capture_, adjustment(), progress_);
        }
        std::optional<AdjustmentCovariance> covariance =
            adjustment_covariance(capture_, adjustment());
        if (policy_ == LensPolicy::kAuto && covariance && drop_unsupported(*covariance)) {
            adjust_bundle(capture_, adjustment(), progress_);
            covariance = adjustment_covariance(capture_, adjustment());
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

    bool drop_unsupported(const AdjustmentCovariance& covariance) {
        bool any = false;
        for (std::size_t camera = 0; camera < capture_.cameras.size(); ++camera) {
            LensEvidence& evidence = evidence_.lenses[camera];
            const SupportedLens supported =
                supported_lens(capture_.cameras[camera], evidence.form, covariance.lenses[camera]);
            if (supported.form == evidence.form) continue;
            evidence.dropped = supported.dropped;
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
        if (!covariance) {
            evidence_.warnings.emplace_back(
                "how certain poses and lenses are is not known: there are too many photographs, or "
                "too little speaks for them");
            return;
        }
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
        warn_of_jitter();
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

    void warn_of_jitter() {
        const auto uncertain =
            std::count_if(evidence_.views.begin(), evidence_.views.end(),
                          [](const auto& view) { return view.jitter_px > kMaxJitter_px; });
        if (uncertain == 0) return;
        const auto worst = std::max_element(
            evidence_.views.begin(), evidence_.views.end(),
            [](const auto& a, const auto& b) { return a.jitter_px < b.jitter_px; });
        std::array<char, 32> jitter{};
        std::snprintf(jitter.data(), jitter.size(), "%.2g", worst->jitter_px);
        evidence_.warnings.push_back(
            std::to_string(uncertain) + " of " + std::to_string(evidence_.views.size()) +
            " photographs are placed to no better than 0.3 px (" + worst->name + ": " +
            jitter.data() +
            " px): blended pictures may show ghosts. Add photographs that overlap "
            "more, or calibrate the lens with a board");
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
