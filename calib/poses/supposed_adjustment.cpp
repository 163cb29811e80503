#include "calib/poses/supposed_adjustment.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "calib/adjust/longest_tracks.h"
#include "calib/adjust/quiet_solver.h"
#include "calib/adjust/stop_on_interrupt.h"
#include "calib/poses/residual_pattern.h"
#include "calib/poses/supposed_costs.h"

namespace lumi {
namespace {

constexpr int kPointsAPhotograph = 400;

bool has_own_scale(Supposition supposition) {
    return supposition == Supposition::kZoomed || supposition == Supposition::kShifted;
}

int parameters_of_view(Supposition supposition) {
    switch (supposition) {
        case Supposition::kSteady:
            return 0;
        case Supposition::kZoomed:
            return 1;
        case Supposition::kTurning:
        case Supposition::kShifted:
            return 3;
    }
    return 0;
}

/// What a view has of its own: the turn from the first row to the last (rad, about the camera's
/// axes), the place of the principal point (px, from where the lens has it), and the logarithm of
/// the scale. What the supposition leaves out stays zero.
struct OwnParameters {
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();
    Eigen::Vector3d crop = Eigen::Vector3d::Zero();
};

struct Seen {
    std::size_t point;
    std::size_t view;
    SightCost cost;
};

/// Those with the longest tracks, until every view has enough.
std::vector<std::size_t> leading_points(const Capture& capture) {
    std::vector<std::vector<int>> views_of_point;
    for (const ScenePoint& point : capture.points) {
        std::vector<int>& views = views_of_point.emplace_back();
        for (const Observation& seen : point.track) views.push_back(seen.view_index);
    }
    return longest_tracks(views_of_point, capture.views.size(), kPointsAPhotograph);
}

/// One of the adjustments.
class Fit {
 public:
    Fit(const Capture& capture, Supposition supposition, SupposedLens lenses)
        : capture_(capture),
          supposition_(supposition),
          lenses_(lenses),
          own_(capture.views.size()),
          zooms_(capture.cameras.size(), 0.0),
          radials_(capture.cameras.size(), Eigen::Vector2d::Zero()),
          middles_px_(capture.cameras.size(), Eigen::Vector2d::Zero()) {
        for (const std::size_t point : leading_points(capture)) {
            for (const Observation& seen : capture.points[point].track) look_at(point, seen);
        }
    }

    void run(const Progress& progress) {
        ceres::Problem::Options ownership;
        ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
        ceres::CauchyLoss robust(1.0);
        ceres::Problem problem(ownership);
        auto order = std::make_shared<ceres::ParameterBlockOrdering>();
        for (const Seen& seen : all_) {
            Rigid3& pose = capture_.views[seen.view].cam_from_world;
            double* const point = capture_.points[seen.point].position_in_world.data();
            problem.AddResidualBlock(
                new ceres::AutoDiffCostFunction<SightCost, 2, 4, 3, 3, 3, 1, 2, 2, 3>(
                    new SightCost(seen.cost)),
                &robust, pose.rotation.coeffs().data(), pose.translation.data(),
                own_[seen.view].turn.data(), own_[seen.view].crop.data(),
                &zooms_[lens_of(seen.view)], radials_[lens_of(seen.view)].data(),
                middles_px_[lens_of(seen.view)].data(), point);
            order->AddElementToGroup(point, 0);
        }
        hold(problem, *order);
        if (supposition_ == Supposition::kTurning) expect_nothing_in_common(problem);
        StopOnInterrupt stop(progress);
        ceres::Solver::Options solver = quiet_solver_options();
        solver.linear_solver_type =
            capture_.views.size() <= 40 ? ceres::DENSE_SCHUR : ceres::SPARSE_SCHUR;
        solver.linear_solver_ordering = order;
        solver.max_num_iterations = 100;
        solver.function_tolerance = 1e-6;
        // The scale of the model stays free: the damping that holds it must not vanish.
        solver.max_trust_region_radius = 1e8;
        solver.callbacks = {&stop};
        ceres::Solver::Summary summary;
        ceres::Solve(solver, &problem, &summary);
        progress.throw_if_interrupted();
    }

    [[nodiscard]] std::size_t observations() const { return all_.size(); }

    [[nodiscard]] double truncated_cost_px2(double limit_px) const {
        double cost_px2 = 0;
        for (const Seen& seen : all_) cost_px2 += truncated_square_px2(seen, limit_px);
        return cost_px2;
    }

    /// Root mean square over the views.
    [[nodiscard]] double effect_px() const {
        double sum_px2 = 0;
        for (std::size_t index = 0; index < own_.size(); ++index) {
            const Camera& camera = camera_of(capture_, capture_.views[index]);
            const double skew_px = own_[index].turn.norm() * focal_length_px(camera).mean();
            sum_px2 += skew_px * skew_px + middle_px(index).squaredNorm();
        }
        return std::sqrt(sum_px2 / static_cast<double>(own_.size()));
    }

    /// Of the mean over the views.
    [[nodiscard]] double common_px() const {
        Eigen::Vector2d sum_px = Eigen::Vector2d::Zero();
        for (std::size_t index = 0; index < own_.size(); ++index) sum_px += middle_px(index);
        return sum_px.norm() / static_cast<double>(own_.size());
    }

    /// As adjusted; lenses as they came, through which a picture whose middle lies elsewhere is
    /// that of a camera that is turned.
    [[nodiscard]] Capture capture() const {
        Capture adjusted = capture_;
        for (std::size_t index = 0; index < own_.size(); ++index) {
            View& view = adjusted.views[index];
            const double focal_px = focal_length_px(camera_of(adjusted, view)).mean();
            const Eigen::Vector2d middle = middle_px(index);
            const Eigen::Vector3d axis(middle.x(), middle.y(), focal_px);
            view.cam_from_world.rotation.normalize();
            view.cam_from_world =
                Rigid3{Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis),
                       Eigen::Vector3d::Zero()} *
                view.cam_from_world;
        }
        return adjusted;
    }

 private:
    void look_at(std::size_t point, const Observation& seen) {
        const auto view = static_cast<std::size_t>(seen.view_index);
        const Camera& camera = camera_of(capture_, capture_.views[view]);
        const Eigen::Vector3d in_cam =
            capture_.views[view].cam_from_world * capture_.points[point].position_in_world;
        if (!(in_cam.z() > 1e-6)) return;
        if (const auto sight = straight_sight(camera, seen.pixel))
            all_.push_back({point, view, SightCost(*sight)});
    }

    [[nodiscard]] std::size_t lens_of(std::size_t view) const {
        return static_cast<std::size_t>(capture_.views[view].camera_index);
    }

    /// Where the middle of the lens is in a view's picture, from where the lens has it.
    [[nodiscard]] Eigen::Vector2d middle_px(std::size_t view) const {
        return middles_px_[lens_of(view)] + own_[view].crop.head<2>();
    }

    /// The gauge, the priors, and what is held.
    void hold(ceres::Problem& problem, ceres::ParameterBlockOrdering& order) {
        bool is_first = true;
        for (std::size_t index = 0; index < capture_.views.size(); ++index) {
            Rigid3& pose = capture_.views[index].cam_from_world;
            if (!problem.HasParameterBlock(pose.translation.data())) continue;
            double* const turn = own_[index].turn.data();
            double* const crop = own_[index].crop.data();
            double* const zoom = &zooms_[lens_of(index)];
            double* const radial = radials_[lens_of(index)].data();
            double* const middle = middles_px_[lens_of(index)].data();
            const double focal_px =
                focal_length_px(camera_of(capture_, capture_.views[index])).mean();
            problem.SetManifold(pose.rotation.coeffs().data(), new ceres::EigenQuaternionManifold);
            for (double* const block : {pose.rotation.coeffs().data(), pose.translation.data(),
                                        turn, crop, zoom, radial, middle}) {
                order.AddElementToGroup(block, 1);
            }
            // A picture's width of skew, shift or growth weighs as much as so many pixels.
            constexpr double kWeight = 0.02;
            const double of_angle = kWeight * focal_px;
            free_or_hold<3>(problem, turn, supposition_ == Supposition::kTurning,
                            {of_angle, of_angle, of_angle});
            free_or_hold<3>(problem, crop, has_own_scale(supposition_),
                            {kWeight, kWeight, of_angle});
            free_or_hold<2>(problem, middle, lenses_ == SupposedLens::kFree, {kWeight, kWeight});
            if (supposition_ == Supposition::kZoomed) {
                problem.SetManifold(crop, new ceres::SubsetManifold(3, {0, 1}));
            }
            if (lenses_ == SupposedLens::kHeld) {
                problem.SetParameterBlockConstant(zoom);
                problem.SetParameterBlockConstant(radial);
            }
            if (is_first) {
                problem.SetParameterBlockConstant(pose.rotation.coeffs().data());
                problem.SetParameterBlockConstant(pose.translation.data());
                is_first = false;
            }
        }
    }

    void expect_nothing_in_common(ceres::Problem& problem) {
        constexpr double kWeight = 1.0;  // Pixels of skew.
        std::vector<Eigen::Matrix3d> world_from_cam;
        std::vector<double*> turns;
        double focal_px = 0;
        for (std::size_t index = 0; index < own_.size(); ++index) {
            if (!problem.HasParameterBlock(own_[index].turn.data())) continue;
            const View& view = capture_.views[index];
            world_from_cam.emplace_back(
                view.cam_from_world.rotation.conjugate().toRotationMatrix());
            turns.push_back(own_[index].turn.data());
            focal_px = std::max(focal_px, focal_length_px(camera_of(capture_, view)).mean());
        }
        problem.AddResidualBlock(new NothingInCommon(std::move(world_from_cam), kWeight * focal_px),
                                 nullptr, turns);
    }

    template <int kValues>
    static void free_or_hold(ceres::Problem& problem, double* block, bool is_free,
                             const typename NearZero<kValues>::Weights& weights) {
        if (is_free) {
            using Prior = NearZero<kValues>;
            problem.AddResidualBlock(
                new ceres::AutoDiffCostFunction<Prior, kValues, kValues>(new Prior(weights)),
                nullptr, block);
        } else {
            problem.SetParameterBlockConstant(block);
        }
    }

    [[nodiscard]] double truncated_square_px2(const Seen& seen, double limit_px) const {
        const View& view = capture_.views[seen.view];
        Eigen::Vector2d residual_px;
        const bool is_in_front = seen.cost(
            view.cam_from_world.rotation.coeffs().data(), view.cam_from_world.translation.data(),
            own_[seen.view].turn.data(), own_[seen.view].crop.data(), &zooms_[lens_of(seen.view)],
            radials_[lens_of(seen.view)].data(), middles_px_[lens_of(seen.view)].data(),
            capture_.points[seen.point].position_in_world.data(), residual_px.data());
        const double limit_px2 = limit_px * limit_px;
        return is_in_front ? std::min(limit_px2, residual_px.squaredNorm()) : limit_px2;
    }

    Capture capture_;
    Supposition supposition_;
    SupposedLens lenses_;
    std::vector<OwnParameters> own_;  ///< One a view.
    std::vector<double> zooms_;       ///< Logarithms; one a lens, as the next.
    std::vector<Eigen::Vector2d> radials_;
    std::vector<Eigen::Vector2d> middles_px_;  ///< From where the lens has it.
    std::vector<Seen> all_;
};

}  // namespace

SupposedAdjustment adjust_supposing(Supposition supposition, const Capture& capture,
                                    SupposedLens lenses, double limit_px,
                                    const Progress& progress) {
    Fit fit(capture, supposition, lenses);
    fit.run(progress);
    return {fit.capture(),
            fit.truncated_cost_px2(limit_px),
            fit.effect_px(),
            fit.common_px(),
            parameters_of_view(supposition) * static_cast<int>(capture.views.size()),
            fit.observations()};
}

bool own_scales_explain_better(const Capture& capture, bool lenses_are_held, double limit_px,
                               const Progress& progress) {
    const auto adjusted = [&](Supposition supposition, SupposedLens lenses) {
        return adjust_supposing(supposition, capture,
                                lenses_are_held ? SupposedLens::kHeld : lenses, limit_px, progress);
    };
    const SupposedAdjustment steady = adjusted(Supposition::kSteady, SupposedLens::kFree);
    const auto is_better = [&](const SupposedAdjustment& scaled) {
        return explains_better(steady.cost_px2, scaled.cost_px2, scaled.parameters,
                               capture.points.size());
    };
    return is_better(adjusted(Supposition::kZoomed, SupposedLens::kMiddleHeld)) ||
           (!lenses_are_held && is_better(adjusted(Supposition::kZoomed, SupposedLens::kFree)));
}

}  // namespace lumi
