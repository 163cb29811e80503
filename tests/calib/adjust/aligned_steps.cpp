#include "tests/calib/adjust/aligned_steps.h"

#include <Eigen/Dense>
#include <cmath>

namespace lumi {
namespace {

using Vector7 = Eigen::Matrix<double, 7, 1>;
using Matrix7 = Eigen::Matrix<double, 7, 7>;

Eigen::Quaterniond turn_of(const Eigen::Vector3d& vector) {
    const double angle = vector.norm();
    if (angle == 0) return Eigen::Quaterniond::Identity();
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d(vector / angle)));
}

/// The pose of the same camera when the world is turned, moved and scaled.
Rigid3 in_moved_world(const Rigid3& pose, const Vector7& step) {
    Rigid3 moved;
    moved.rotation = (pose.rotation * turn_of(step.head<3>()).conjugate()).normalized();
    moved.translation =
        std::exp(step[6]) * pose.translation - moved.rotation * Eigen::Vector3d(step.segment<3>(3));
    return moved;
}

/// One Gauss-Newton step towards pictures that agree.
Vector7 world_step(const Capture& truth, const Capture& estimate) {
    std::vector<double> count(truth.views.size(), 0.0);
    for (const ScenePoint& point : truth.points) {
        for (const Observation& seen : point.track) {
            count[static_cast<std::size_t>(seen.view_index)] += 1;
        }
    }
    Matrix7 normal = Matrix7::Zero();
    Vector7 right = Vector7::Zero();
    for (const ScenePoint& point : truth.points) {
        for (const Observation& seen : point.track) {
            const auto index = static_cast<std::size_t>(seen.view_index);
            const View& view = estimate.views[index];
            const Camera& lens = camera_of(estimate, view);
            const auto pixel = [&](const Vector7& step) {
                return project(lens,
                               in_moved_world(view.cam_from_world, step) * point.position_in_world)
                    .value();
            };
            Eigen::Matrix<double, 2, 7> derivative;
            for (Eigen::Index unknown = 0; unknown < 7; ++unknown) {
                const Vector7 step = 1e-6 * Vector7::Unit(unknown);
                derivative.col(unknown) = (pixel(step) - pixel(-step)) / 2e-6;
            }
            const View& true_view = truth.views[index];
            const Eigen::Vector2d expected =
                project(camera_of(truth, true_view),
                        true_view.cam_from_world * point.position_in_world)
                    .value();
            normal += derivative.transpose() * derivative / count[index];
            right += derivative.transpose() * (expected - pixel(Vector7::Zero())) / count[index];
        }
    }
    return normal.ldlt().solve(right);
}

}  // namespace

std::vector<Vector6> aligned_pose_steps(const Capture& truth, const Capture& estimate) {
    Capture moved = estimate;
    for (int iteration = 0; iteration < 2; ++iteration) {
        const Vector7 step = world_step(truth, moved);
        for (View& view : moved.views)
            view.cam_from_world = in_moved_world(view.cam_from_world, step);
    }
    std::vector<Vector6> steps;
    for (std::size_t view = 0; view < truth.views.size(); ++view) {
        const Rigid3& from = truth.views[view].cam_from_world;
        const Rigid3& to = moved.views[view].cam_from_world;
        const Eigen::AngleAxisd turn(
            Eigen::Quaterniond(to.rotation * from.rotation.conjugate()).normalized());
        Vector6 step;
        step << turn.angle() * turn.axis(), to.translation - from.translation;
        steps.push_back(step);
    }
    return steps;
}

}  // namespace lumi
