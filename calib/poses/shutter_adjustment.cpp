#include "calib/poses/shutter_adjustment.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "calib/poses/residual_pattern.h"

namespace lumi {
namespace {

/// Parameter blocks: rotation and translation cam_from_world at the middle row, the turn from the
/// first row to the last (rad, about the camera's axes), the point.
class ShutterCost {
 public:
    ShutterCost(const Eigen::Vector2d& direction, const Eigen::Vector2d& focal_px, double time)
        : direction_(direction), focal_px_(focal_px), time_(time) {}

    template <class T>
    bool operator()(const T* rotation, const T* translation, const T* turn, const T* point,
                    T* residual) const {
        using Vector3 = Eigen::Matrix<T, 3, 1>;
        const Vector3 at_middle =
            Eigen::Map<const Eigen::Quaternion<T>>(rotation) * Eigen::Map<const Vector3>(point) +
            Eigen::Map<const Vector3>(translation);
        const Vector3 turned =
            at_middle + T(time_) * Eigen::Map<const Vector3>(turn).cross(at_middle);
        if (!(turned.z() > T(1e-9))) return false;
        residual[0] = focal_px_.x() * (turned.x() / turned.z() - direction_.x());
        residual[1] = focal_px_.y() * (turned.y() / turned.z() - direction_.y());
        return true;
    }

 private:
    Eigen::Vector2d direction_;
    Eigen::Vector2d focal_px_;
    double time_;
};

/// Holds a turn near zero: a picture's width of skew weighs as much as so many pixels.
class SteadyHand {
 public:
    explicit SteadyHand(double weight) : weight_(weight) {}
    template <class T>
    bool operator()(const T* turn, T* residual) const {
        for (int axis = 0; axis < 3; ++axis) residual[axis] = T(weight_) * turn[axis];
        return true;
    }

 private:
    double weight_;
};

struct Seen {
    std::size_t point;
    std::size_t view;
    Eigen::Vector2d direction;
    Eigen::Vector2d focal_px;
    double time;
};

std::vector<Seen> observations_of(const Capture& capture) {
    std::vector<Seen> all;
    for (std::size_t point = 0; point < capture.points.size(); ++point) {
        for (const Observation& seen : capture.points[point].track) {
            const auto view = static_cast<std::size_t>(seen.view_index);
            const Camera& camera = camera_of(capture, capture.views[view]);
            const Eigen::Vector3d in_cam =
                capture.views[view].cam_from_world * capture.points[point].position_in_world;
            if (!(in_cam.z() > 1e-6)) continue;
            all.push_back({point, view, unproject(camera, seen.pixel).head<2>(),
                           focal_length_px(camera), seen.pixel.y() / camera.height_px - 0.5});
        }
    }
    return all;
}

double truncated_square(const Capture& capture, const std::vector<Eigen::Vector3d>& turns,
                        const Seen& seen, double limit_px) {
    const Eigen::Vector3d at_middle =
        capture.views[seen.view].cam_from_world * capture.points[seen.point].position_in_world;
    const Eigen::Vector3d turned = at_middle + seen.time * turns[seen.view].cross(at_middle);
    const double limit = limit_px * limit_px;
    if (!(turned.z() > 1e-9)) return limit;
    const Eigen::Vector2d residual =
        seen.focal_px.cwiseProduct(turned.head<2>() / turned.z() - seen.direction);
    return std::min(limit, residual.squaredNorm());
}

}  // namespace

ShutterAdjustment adjust_for_shutter(const Capture& capture, double limit_px, Progress& progress) {
    progress.begin("asking whether the rows were taken at one moment", 0);
    ShutterAdjustment result{capture, 0.0, 0.0, 3 * static_cast<int>(capture.views.size())};
    std::vector<Eigen::Vector3d> turns(capture.views.size(), Eigen::Vector3d::Zero());
    const std::vector<Seen> all = observations_of(capture);
    ceres::Problem::Options ownership;
    ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::CauchyLoss robust(1.0);
    ceres::Problem problem(ownership);
    auto order = std::make_shared<ceres::ParameterBlockOrdering>();
    for (const Seen& seen : all) {
        View& view = result.capture.views[seen.view];
        double* const point = result.capture.points[seen.point].position_in_world.data();
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<ShutterCost, 2, 4, 3, 3, 3>(
                                     new ShutterCost(seen.direction, seen.focal_px, seen.time)),
                                 &robust, view.cam_from_world.rotation.coeffs().data(),
                                 view.cam_from_world.translation.data(), turns[seen.view].data(),
                                 point);
        order->AddElementToGroup(point, 0);
    }
    bool is_first = true;
    for (std::size_t index = 0; index < capture.views.size(); ++index) {
        Rigid3& pose = result.capture.views[index].cam_from_world;
        if (!problem.HasParameterBlock(pose.translation.data())) continue;
        const Camera& camera = camera_of(capture, capture.views[index]);
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<SteadyHand, 3, 3>(
                                     new SteadyHand(0.02 * focal_length_px(camera).mean())),
                                 nullptr, turns[index].data());
        problem.SetManifold(pose.rotation.coeffs().data(), new ceres::EigenQuaternionManifold);
        for (double* const block :
             {pose.rotation.coeffs().data(), pose.translation.data(), turns[index].data()}) {
            order->AddElementToGroup(block, 1);
        }
        if (is_first) {  // The scale stays free: its direction is damped by the solver.
            problem.SetParameterBlockConstant(pose.rotation.coeffs().data());
            problem.SetParameterBlockConstant(pose.translation.data());
            is_first = false;
        }
    }
    ceres::Solver::Options solver;
    solver.linear_solver_type =
        capture.views.size() <= 40 ? ceres::DENSE_SCHUR : ceres::SPARSE_SCHUR;
    solver.linear_solver_ordering = order;
    solver.max_num_iterations = 40;
    solver.function_tolerance = 1e-4;
    solver.num_threads = 1;
    solver.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    progress.throw_if_interrupted();
    double skew_sum = 0;
    for (std::size_t index = 0; index < turns.size(); ++index) {
        result.capture.views[index].cam_from_world.rotation.normalize();
        const Camera& camera = camera_of(capture, capture.views[index]);
        const double skew_px = turns[index].norm() * focal_length_px(camera).mean();
        skew_sum += skew_px * skew_px / static_cast<double>(turns.size());
    }
    result.skew_px = std::sqrt(skew_sum);
    for (const Seen& seen : all) {
        result.cost_px2 += truncated_square(result.capture, turns, seen, limit_px);
    }
    result.cost_px2 +=
        static_cast<double>(count_observations(capture) - all.size()) * limit_px * limit_px;
    return result;
}

}  // namespace lumi
