#include "calib/poses/shutter_adjustment.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include "calib/lens/lens_form.h"

namespace lumi {
namespace {

constexpr int kPointsAPhotograph = 400;

/// Parameter blocks: rotation and translation cam_from_world at the middle row, the turn from the
/// first row to the last (rad, about the camera's axes), the logarithm of the focal length over
/// that of the lens, its two coefficients of radial distortion, the point.
class ShutterCost {
 public:
    /// `pixel` is counted from the principal point.
    ShutterCost(const Eigen::Vector2d& pixel, double focal_px, double time)
        : pixel_(pixel), focal_px_(focal_px), time_(time) {}

    template <class T>
    bool operator()(const T* rotation, const T* translation, const T* turn, const T* zoom,
                    const T* radial, const T* point, T* residual) const {
        using std::exp;
        using Vector3 = Eigen::Matrix<T, 3, 1>;
        const Vector3 at_middle =
            Eigen::Map<const Eigen::Quaternion<T>>(rotation) * Eigen::Map<const Vector3>(point) +
            Eigen::Map<const Vector3>(translation);
        const Vector3 turned =
            at_middle + T(time_) * Eigen::Map<const Vector3>(turn).cross(at_middle);
        if (!(turned.z() > T(1e-9))) return false;
        const T x = turned.x() / turned.z();
        const T y = turned.y() / turned.z();
        const T square = x * x + y * y;
        const T scale =
            T(focal_px_) * exp(zoom[0]) * (T(1) + square * (radial[0] + square * radial[1]));
        residual[0] = scale * x - T(pixel_.x());
        residual[1] = scale * y - T(pixel_.y());
        return true;
    }

 private:
    Eigen::Vector2d pixel_;
    double focal_px_;
    double time_;
};

/// Holds values near zero.
class NearZero {
 public:
    NearZero(int count, double weight) : count_(count), weight_(weight) {}
    template <class T>
    bool operator()(const T* value, T* residual) const {
        for (int index = 0; index < count_; ++index) residual[index] = T(weight_) * value[index];
        return true;
    }

 private:
    int count_;
    double weight_;
};

struct Seen {
    std::size_t point;
    std::size_t view;
    ShutterCost cost;
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

/// One of the two adjustments.
class Fit {
 public:
    Fit(const Capture& capture, bool cameras_turn, bool lenses_are_held)
        : capture_(capture),
          cameras_turn_(cameras_turn),
          lenses_are_held_(lenses_are_held),
          turns_(capture.views.size(), Eigen::Vector3d::Zero()),
          zooms_(capture.cameras.size(), 0.0) {
        for (const Camera& lens : capture.cameras) {
            // A lens that is held keeps its distortion: pixels are taken as a pinhole would see
            // them.
            radials_.push_back(lenses_are_held ? Eigen::Vector2d::Zero()
                                               : Eigen::Vector2d(radial_of(lens)));
        }
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
                new ceres::AutoDiffCostFunction<ShutterCost, 2, 4, 3, 3, 1, 2, 3>(
                    new ShutterCost(seen.cost)),
                &robust, pose.rotation.coeffs().data(), pose.translation.data(),
                turns_[seen.view].data(), &zooms_[lens_of(seen.view)],
                radials_[lens_of(seen.view)].data(), point);
            order->AddElementToGroup(point, 0);
        }
        hold(problem, *order);
        ceres::Solver::Options solver;
        solver.linear_solver_type =
            capture_.views.size() <= 40 ? ceres::DENSE_SCHUR : ceres::SPARSE_SCHUR;
        solver.linear_solver_ordering = order;
        solver.max_num_iterations = 100;
        solver.function_tolerance = 1e-6;
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
    [[nodiscard]] double skew_px() const {
        double sum_px2 = 0;
        for (std::size_t index = 0; index < turns_.size(); ++index) {
            const Camera& camera = camera_of(capture_, capture_.views[index]);
            const double skew = turns_[index].norm() * focal_length_px(camera).mean();
            sum_px2 += skew * skew / static_cast<double>(turns_.size());
        }
        return std::sqrt(sum_px2);
    }

    /// As adjusted; lenses that were not held as RADIAL.
    [[nodiscard]] Capture capture() const {
        Capture adjusted = capture_;
        for (View& view : adjusted.views) view.cam_from_world.rotation.normalize();
        for (std::size_t lens = 0; lens < zooms_.size() && !lenses_are_held_; ++lens) {
            Camera camera = in_model(capture_.cameras[lens], LensModel::kRadial);
            camera.parameters[0] *= std::exp(zooms_[lens]);
            camera.parameters[3] = radials_[lens].x();
            camera.parameters[4] = radials_[lens].y();
            adjusted.cameras[lens] = std::move(camera);
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
        const double focal_px = focal_length_px(camera).mean();
        const Eigen::Vector2d pixel =
            lenses_are_held_ ? Eigen::Vector2d(focal_px * unproject(camera, seen.pixel).head<2>())
                             : Eigen::Vector2d(seen.pixel - principal_point_px(camera));
        all_.push_back(
            {point, view, ShutterCost(pixel, focal_px, seen.pixel.y() / camera.height_px - 0.5)});
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
            double* const turn = turns_[index].data();
            double* const zoom = &zooms_[lens_of(index)];
            double* const radial = radials_[lens_of(index)].data();
            const double focal_px =
                focal_length_px(camera_of(capture_, capture_.views[index])).mean();
            problem.SetManifold(pose.rotation.coeffs().data(), new ceres::EigenQuaternionManifold);
            for (double* const block :
                 {pose.rotation.coeffs().data(), pose.translation.data(), turn, zoom, radial}) {
                order.AddElementToGroup(block, 1);
            }
            if (cameras_turn_) {
                // A picture's width of skew weighs as much as so many pixels.
                problem.AddResidualBlock(new ceres::AutoDiffCostFunction<NearZero, 3, 3>(
                                             new NearZero(3, 0.02 * focal_px)),
                                         nullptr, turn);
            } else {
                problem.SetParameterBlockConstant(turn);
            }
            if (lenses_are_held_) {
                problem.SetParameterBlockConstant(zoom);
                problem.SetParameterBlockConstant(radial);
            }
            if (is_first) {  // The scale stays free: its direction is damped by the solver.
                problem.SetParameterBlockConstant(pose.rotation.coeffs().data());
                problem.SetParameterBlockConstant(pose.translation.data());
                is_first = false;
            }
        }
    }

    [[nodiscard]] double truncated_square_px2(const Seen& seen, double limit_px) const {
        const View& view = capture_.views[seen.view];
        Eigen::Vector2d residual_px;
        const bool is_in_front =
            seen.cost(view.cam_from_world.rotation.coeffs().data(),
                      view.cam_from_world.translation.data(), turns_[seen.view].data(),
                      &zooms_[lens_of(seen.view)], radials_[lens_of(seen.view)].data(),
                      capture_.points[seen.point].position_in_world.data(), residual_px.data());
        const double limit_px2 = limit_px * limit_px;
        return is_in_front ? std::min(limit_px2, residual_px.squaredNorm()) : limit_px2;
    }

    static Eigen::Vector2d radial_of(const Camera& lens) {
        const Camera radial = in_model(lens, LensModel::kRadial);
        return {radial.parameters[3], radial.parameters[4]};
    }

    Capture capture_;
    bool cameras_turn_;
    bool lenses_are_held_;
    std::vector<Eigen::Vector3d> turns_;  ///< One a view.
    std::vector<double> zooms_;           ///< Logarithms; one a lens, as the next.
    std::vector<Eigen::Vector2d> radials_;
    std::vector<Seen> all_;
};

}  // namespace

ShutterAdjustment adjust_for_shutter(const Capture& capture, bool lenses_are_held, double limit_px,
                                     Progress& progress) {
    progress.begin("asking whether the rows were taken at one moment", 0);
    Fit steady(capture, false, lenses_are_held);
    steady.run();
    progress.throw_if_interrupted();
    Fit turning(capture, true, lenses_are_held);
    turning.run();
    progress.throw_if_interrupted();
    return {steady.capture(),
            turning.capture(),
            steady.truncated_cost_px2(limit_px),
            turning.truncated_cost_px2(limit_px),
            turning.skew_px(),
            3 * static_cast<int>(capture.views.size()),
            turning.observations()};
}

}  // namespace lumi
