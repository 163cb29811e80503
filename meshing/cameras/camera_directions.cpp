#include "meshing/cameras/camera_directions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace lumi {
namespace {

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Median over the cameras of the angle to the nearest camera elsewhere.
double median_spacing_rad(const std::vector<CameraDirection>& cameras, double coincident_rad) {
    std::vector<double> spacings;
    for (const CameraDirection& camera : cameras) {
        double nearest = std::numbers::pi;
        for (const CameraDirection& other : cameras) {
            const double angle = angle_between(camera.direction, other.direction);
            if (angle > coincident_rad) nearest = std::min(nearest, angle);
        }
        spacings.push_back(nearest);
    }
    const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
    std::nth_element(spacings.begin(), middle, spacings.end());
    return *middle;
}

Eigen::Vector3d turned_aside(const Eigen::Vector3d& direction, double angle_rad, int step) {
    constexpr double kGoldenAngle = 2.399963229728653;
    const Eigen::Vector3d side =
        Eigen::AngleAxisd(step * kGoldenAngle, direction) * orthogonal_unit(direction);
    return (std::cos(angle_rad) * direction + std::sin(angle_rad) * side).normalized();
}

void separate_coincident(std::vector<CameraDirection>& cameras) {
    constexpr double kCoincidentRad = 1e-7;
    constexpr double kShareOfSpacing = 0.01;
    double aside_rad = 0;
    int step = 0;
    for (std::size_t i = 1; i < cameras.size(); ++i) {
        const bool coincides = std::any_of(
            cameras.begin(), cameras.begin() + static_cast<std::ptrdiff_t>(i),
            [&](const CameraDirection& earlier) {
                return angle_between(earlier.direction, cameras[i].direction) < kCoincidentRad;
            });
        if (!coincides) continue;
        if (aside_rad == 0)
            aside_rad = kShareOfSpacing * median_spacing_rad(cameras, kCoincidentRad);
        cameras[i].direction = turned_aside(cameras[i].direction, aside_rad, step++);
    }
}

}  // namespace

Eigen::Vector3d orthogonal_unit(const Eigen::Vector3d& axis) {
    Eigen::Index smallest = 0;
    axis.cwiseAbs().minCoeff(&smallest);
    return axis.cross(Eigen::Vector3d::Unit(smallest)).normalized();
}

std::vector<CameraDirection> camera_directions(const Capture& capture,
                                               const std::vector<int>& view_indices,
                                               const Eigen::Vector3d& centre) {
    std::vector<CameraDirection> cameras;
    for (const int index : view_indices) {
        const View& view = capture.views[static_cast<std::size_t>(index)];
        const Eigen::Vector3d from_centre = centre_in_world(view.cam_from_world) - centre;
        const double radius = from_centre.norm();
        const Eigen::Vector3d direction =
            radius > 0 ? Eigen::Vector3d(from_centre / radius)
                       : Eigen::Vector3d(-optical_axis_in_world(view.cam_from_world));
        cameras.push_back({index, direction, radius});
    }
    separate_coincident(cameras);
    return cameras;
}

}  // namespace lumi
