#include "meshing/cameras/scene_centre.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace lumi {
namespace {

struct OpticalAxis {
    Eigen::Vector3d centre;
    Eigen::Vector3d direction;
};

std::vector<OpticalAxis> optical_axes(const Capture& capture,
                                      const std::vector<int>& view_indices) {
    std::vector<OpticalAxis> axes;
    for (const int index : view_indices) {
        const Rigid3& pose = capture.views[static_cast<std::size_t>(index)].cam_from_world;
        axes.push_back({centre_in_world(pose), optical_axis_in_world(pose)});
    }
    return axes;
}

Eigen::Vector3d mean_centre(const std::vector<OpticalAxis>& axes) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const OpticalAxis& axis : axes) sum += axis.centre;
    return sum / static_cast<double>(axes.size());
}

/// The least-squares point of the axes; empty when they are too parallel to tell, or when the point
/// lies behind a fifth of the cameras.
std::optional<Eigen::Vector3d> convergence_of(const std::vector<OpticalAxis>& axes) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const OpticalAxis& axis : axes) {
        const Eigen::Matrix3d across =
            Eigen::Matrix3d::Identity() - axis.direction * axis.direction.transpose();
        normal += across;
        right += across * axis.centre;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(normal);
    constexpr double kMinSineSquared = 0.01;  // Axes within about six degrees of each other.
    if (eigen.eigenvalues()(0) < kMinSineSquared * static_cast<double>(axes.size())) {
        return std::nullopt;
    }
    const Eigen::Vector3d point = normal.ldlt().solve(right);
    const auto behind = std::count_if(axes.begin(), axes.end(), [&](const OpticalAxis& axis) {
        return (point - axis.centre).dot(axis.direction) <= 0;
    });
    if (5 * static_cast<std::size_t>(behind) > axes.size()) return std::nullopt;
    return point;
}

std::vector<Eigen::Vector3d> shared_points(const Capture& capture,
                                           const std::vector<int>& view_indices) {
    const std::set<int> listed(view_indices.begin(), view_indices.end());
    std::vector<Eigen::Vector3d> points;
    for (const ScenePoint& point : capture.points) {
        const auto seen = std::count_if(point.track.begin(), point.track.end(),
                                        [&](const Observation& observation) {
                                            return listed.contains(observation.view_index);
                                        });
        if (seen >= 2) points.push_back(point.position_in_world);
    }
    return points;
}

double percentile(std::vector<double> values, double share) {
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

Eigen::Vector3d median_point(const std::vector<Eigen::Vector3d>& points) {
    Eigen::Vector3d median;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const Eigen::Vector3d& point : points) values.push_back(point[axis]);
        median[axis] = percentile(values, 0.5);
    }
    return median;
}

Eigen::Vector3d point_ahead(const std::vector<OpticalAxis>& axes) {
    const Eigen::Vector3d middle = mean_centre(axes);
    Eigen::Vector3d forward = Eigen::Vector3d::Zero();
    double spread = 0;
    for (const OpticalAxis& axis : axes) {
        forward += axis.direction;
        spread = std::max(spread, (axis.centre - middle).norm());
    }
    if (forward.norm() < 1e-9) forward = axes.front().direction;
    return middle + forward.normalized() * (spread > 0 ? 2 * spread : 1.0);
}

/// Every camera looks away from where the cameras are, and the scene lies around them.
bool looks_outwards(const std::vector<OpticalAxis>& axes) {
    constexpr std::size_t kMinCameras = 4;
    if (axes.size() < kMinCameras) return false;
    const Eigen::Vector3d middle = mean_centre(axes);
    Eigen::Vector3d mean_direction = Eigen::Vector3d::Zero();
    std::size_t outwards = 0;
    for (const OpticalAxis& axis : axes) {
        mean_direction += axis.direction / static_cast<double>(axes.size());
        if ((axis.centre - middle).dot(axis.direction) > 0) ++outwards;
    }
    constexpr double kAllAround = 0.5;  // Shorter than this, the axes point to all sides.
    return 10 * outwards >= 9 * axes.size() && mean_direction.norm() < kAllAround;
}

}  // namespace

SceneExtent find_scene(const Capture& capture, const std::vector<int>& view_indices) {
    const std::vector<OpticalAxis> axes = optical_axes(capture, view_indices);
    SceneExtent scene;
    scene.points_in_world = shared_points(capture, view_indices);
    scene.inside_out = looks_outwards(axes);

    constexpr std::size_t kEnoughPoints = 10;
    if (scene.inside_out) {
        scene.centre_in_world = mean_centre(axes);
    } else if (const auto convergence = convergence_of(axes)) {
        scene.centre_in_world = *convergence;
    } else if (scene.points_in_world.size() >= kEnoughPoints) {
        scene.centre_in_world = median_point(scene.points_in_world);
    } else {
        scene.centre_in_world = point_ahead(axes);
    }
    if (!scene.points_in_world.empty()) {
        std::vector<double> distances;
        for (const Eigen::Vector3d& point : scene.points_in_world) {
            distances.push_back((point - scene.centre_in_world).norm());
        }
        scene.radius = percentile(distances, 0.9);
    }
    return scene;
}

}  // namespace lumi
