#include "calib/poses/supposed_adjustment.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

namespace lumi {
namespace {

constexpr int kPointsAPhotograph = 400;

/// What a view has of its own: the turn from the first row to the last (rad, about the camera's
/// axes), the place of the principal point (px, from where the lens has it), and the logarithm of
/// the scale. What the supposition leaves out stays zero.
struct OwnParameters {
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();
    Eigen::Vector3d crop = Eigen::Vector3d::Zero();
};

/// What a view saw of a point, as a pinhole of the same focal length would have.
struct StraightSight {
    Eigen::Vector2d straight_px;         ///< From the principal point.
    Eigen::Matrix2d pixel_per_straight;  ///< How errors there show in the picture.
    double focal_px;
    double time;  ///< When its row was read: -0.5 for the first to 0.5 for the last.
};

/// Empty where the lens, far out, does not tell where it was.
std::optional<StraightSight> straight_sight(const Camera& camera, const Eigen::Vector2d& pixel) {
    constexpr double kStep = 1e-4;
    constexpr double kFarOff_px = 0.1;
    const Eigen::Vector3d ray = unproject(camera, pixel);
    const auto again = project(camera, ray);
    if (!again || !((*again - pixel).norm() < kFarOff_px)) return std::nullopt;
    const double focal_px = focal_length_px(camera).mean();
    StraightSight sight{focal_px * ray.head<2>(), Eigen::Matrix2d::Identity(), focal_px,
                        pixel.y() / camera.height_px - 0.5};
    for (int axis = 0; axis < 2; ++axis) {
        const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
        const auto before = project(camera, ray - step);
        const auto behind = project(camera, ray + step);
        if (!before || !behind) return std::nullopt;
        sight.pixel_per_straight.col(axis) = (*behind - *before) / (2 * kStep * focal_px);
    }
    return sight;
}

/// Parameter blocks: rotation and translation cam_from_world at the middle row, the turn and the
/// crop of the view, the logarithm of the focal length over that of the lens, two coefficients of
/// the radial distortion that it lacks, the point.
class SightCost {
 public:
    explicit SightCost(const StraightSight& seen) : seen_(seen) {}

    template <class T>
    bool operator()(const T* rotation, const T* translation, const T* turn, const T* crop,
                    const T* zoom, const T* radial, const T* point, T* residual) const {
        using std::exp;
        using Vector2 = Eigen::Matrix<T, 2, 1>;
        using Vector3 = Eigen::Matrix<T, 3, 1>;
        const Vector3 at_middle =
            Eigen::Map<const Eigen::Quaternion<T>>(rotation) * Eigen::Map<const Vector3>(point) +
            Eigen::Map<const Vector3>(translation);
        const Vector3 turned =
            at_middle + T(seen_.time) * Eigen::Map<const Vector3>(turn).cross(at_middle);
        if (!(turned.z() > T(1e-9))) return false;
        const T x = turned.x() / turned.z();
        const T y = turned.y() / turned.z();
        const T square = x * x + y * y;
        const T scale = T(seen_.focal_px) * exp(zoom[0] + crop[2]) *
                        (T(1) + square * (radial[0] + square * radial[1]));
        const Vector2 straight(scale * x + crop[0] - T(seen_.straight_px.x()),
                               scale * y + crop[1] - T(seen_.straight_px.y()));
        Eigen::Map<Vector2> in_picture(residual);
        in_picture = seen_.pixel_per_straight.template cast<T>() * straight;
        return true;
    }

 private:
    StraightSight seen_;
};

/// Holds values near zero.
class NearZero {
 public:
    explicit NearZero(const Eigen::Vector3d& weights) : weights_(weights) {}
    template <class T>
    bool operator()(const T* values, T* residual) const {
        for (int index = 0; index < 3; ++index)
            residual[index] = T(weights_[index]) * values[index];
        return true;
    }

 private:
    Eigen::Vector3d weights_;
};

struct Seen {
    std::size_t point;
    std::size_t view;
    SightCost cost;
};

/// The points with the longest tracks, until every view has enough.
std::vector<std::size_t> leading_points(const Capture& capture) {
    std::vector<std::size_t> order(capture.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return capture.points[a].track.size() > capture.points[b].track.size();
    });
    std::vector<int> of_view(capture.views.size(), 0);
    std::erase_if(order, [&](std::size_t index) {
        bool is_wanted = false;
        for (const Observation& seen : capture.points[index].track) {
            int& count = of_view[static_cast<std::size_t>(seen.view_index)];
            is_wanted = is_wanted || count < kPointsAPhotograph;
        }
        if (!is_wanted) return true;
        for (const Observation& seen : capture.points[index].track) {
            ++of_view[static_cast<std::size_t>(seen.view_index)];
        }
        return false;
    });
    return order;
}

/// One of the adjustments.
class Fit {
 public:
    Fit(const Capture& capture, Supposition supposition, bool lenses_are_held)
        : capture_(capture),
          supposition_(supposition),
          lenses_are_held_(lenses_are_held),
          own_(capture.views.size()),
          zooms_(capture.cameras.size(), 0.0),
          radials_(capture.cameras.size(), Eigen::Vector2d::Zero()) {
        for (const std::size_t point : leading_points(capture)) {
            for (const Observation& seen : capture.points[point].track) look_at(point, seen);
        }
    }

    void run() {
        ceres::Problem::Options ownership;
        ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
        ceres::CauchyLoss robust(1.0);
        ceres::Problem problem(ownership);
        auto order = std::make_shared<ceres::ParameterBlockOrdering>();
        for (const Seen& seen : all_) {
            Rigid3& pose = capture_.views[seen.view].cam_from_world;
            double* const point = capture_.points[seen.point].position_in_world.data();
            problem.AddResidualBlock(
                new ceres::AutoDiffCostFunction<SightCost, 2, 4, 3, 3, 3, 1, 2, 3>(
                    new SightCost(seen.cost)),
                &robust, pose.rotation.coeffs().data(), pose.translation.data(),
                own_[seen.view].turn.data(), own_[seen.view].crop.data(),
                &zooms_[lens_of(seen.view)], radials_[lens_of(seen.view)].data(), point);
            order->AddElementToGroup(point, 0);
        }
        hold(problem, *order);
        ceres::Solver::Options solver;
        solver.linear_solver_type =
            capture_.views.size() <= 40 ? ceres::DENSE_SCHUR : ceres::SPARSE_SCHUR;
        solver.linear_solver_ordering = order;
        solver.max_num_iterations = 100;
        solver.function_tolerance = 1e-6;
        // The scale of the model stays free: the damping that holds it must not vanish.
        solver.max_trust_region_radius = 1e8;
        solver.num_threads = 1;
        solver.logging_type = ceres::SILENT;
        ceres::Solver::Summary summary;
        ceres::Solve(solver, &problem, &summary);
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
            sum_px2 += skew_px * skew_px + own_[index].crop.head<2>().squaredNorm();
        }
        return std::sqrt(sum_px2 / static_cast<double>(own_.size()));
    }

    /// As adjusted; lenses as they came.
    [[nodiscard]] Capture capture() const {
        Capture adjusted = capture_;
        for (View& view : adjusted.views) view.cam_from_world.rotation.normalize();
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
            const double focal_px =
                focal_length_px(camera_of(capture_, capture_.views[index])).mean();
            problem.SetManifold(pose.rotation.coeffs().data(), new ceres::EigenQuaternionManifold);
            for (double* const block : {pose.rotation.coeffs().data(), pose.translation.data(),
                                        turn, crop, zoom, radial}) {
                order.AddElementToGroup(block, 1);
            }
            // A picture's width of skew, shift or growth weighs as much as so many pixels.
            constexpr double kWeight = 0.02;
            const double of_angle = kWeight * focal_px;
            free_or_hold(problem, turn, supposition_ == Supposition::kTurning,
                         {of_angle, of_angle, of_angle});
            free_or_hold(problem, crop, supposition_ == Supposition::kShifted,
                         {kWeight, kWeight, of_angle});
            if (lenses_are_held_) {
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

    static void free_or_hold(ceres::Problem& problem, double* block, bool is_free,
                             const Eigen::Vector3d& weights) {
        if (is_free) {
            problem.AddResidualBlock(
                new ceres::AutoDiffCostFunction<NearZero, 3, 3>(new NearZero(weights)), nullptr,
                block);
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
            radials_[lens_of(seen.view)].data(),
            capture_.points[seen.point].position_in_world.data(), residual_px.data());
        const double limit_px2 = limit_px * limit_px;
        return is_in_front ? std::min(limit_px2, residual_px.squaredNorm()) : limit_px2;
    }

    Capture capture_;
    Supposition supposition_;
    bool lenses_are_held_;
    std::vector<OwnParameters> own_;  ///< One a view.
    std::vector<double> zooms_;       ///< Logarithms; one a lens, as the next.
    std::vector<Eigen::Vector2d> radials_;
    std::vector<Seen> all_;
};

}  // namespace

SupposedAdjustment adjust_supposing(Supposition supposition, const Capture& capture,
                                    bool lenses_are_held, double limit_px, Progress& progress) {
    Fit fit(capture, supposition, lenses_are_held);
    fit.run();
    progress.throw_if_interrupted();
    return {fit.capture(), fit.truncated_cost_px2(limit_px), fit.effect_px(),
            supposition == Supposition::kSteady ? 0 : 3 * static_cast<int>(capture.views.size()),
            fit.observations()};
}

}  // namespace lumi
