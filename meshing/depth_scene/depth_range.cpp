#include "meshing/depth_scene/depth_range.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "calib/work/median.h"
#include "meshing/warp/parallax.h"

namespace lumi {
namespace {

constexpr std::size_t kMinPoints = 12;

/// Of every scene point inside the picture, whether or not this view's track found it.
std::vector<double> inverse_depths_inside(const DepthScene& scene, const DepthView& view) {
    std::vector<double> inverse_depths;
    for (const ScenePoint& point : scene.points) {
        const Eigen::Vector3d in_cam = view.cam_from_world * point.position_in_world;
        const auto pixel = project(view.camera, in_cam);
        if (pixel && is_inside(view.camera, *pixel)) inverse_depths.push_back(1.0 / in_cam.z());
    }
    return inverse_depths;
}

/// Median over the views of the distance to the nearest other centre that has parallax.
double typical_baseline(const DepthScene& scene) {
    std::vector<Eigen::Vector3d> centres;
    for (const DepthView& view : scene.views) {
        centres.push_back(centre_in_world(view.cam_from_world));
    }
    std::vector<double> nearest;
    for (const Eigen::Vector3d& centre : centres) {
        const double distance = nearest_baseline(centre, centres);
        if (distance > 0) nearest.push_back(distance);
    }
    return quantile_of(std::move(nearest), 0.5);
}

InverseDepthRange widened(std::vector<double> inverse_depths) {
    constexpr double kTail = 0.01;
    return {0.0, 1.5 * quantile_of(std::move(inverse_depths), 1 - kTail)};
}

}  // namespace

std::optional<Eigen::Vector3d> convergence_point(const DepthScene& scene) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
    for (const DepthView& view : scene.views) {
        const Eigen::Vector3d axis = optical_axis_in_world(view.cam_from_world);
        const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
        normal += across;
        right_side += across * centre_in_world(view.cam_from_world);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normal);
    // The smallest eigenvalue is the mean squared sine of the angles between the axes.
    constexpr double kMinSpreadRad = 0.02;
    const double parallel = kMinSpreadRad * kMinSpreadRad * static_cast<double>(scene.views.size());
    if (scene.views.size() < 2 || solver.eigenvalues()(0) < parallel) return std::nullopt;
    return solver.eigenvectors() * solver.eigenvalues().cwiseInverse().asDiagonal() *
           solver.eigenvectors().transpose() * right_side;
}

std::optional<InverseDepthRange> inverse_depth_range(const DepthScene& scene, int index) {
    const DepthView& view = scene.views[static_cast<std::size_t>(index)];
    std::vector<double> inverse_depths = inverse_depths_inside(scene, view);
    if (inverse_depths.size() >= kMinPoints) return widened(std::move(inverse_depths));

    const double baseline = typical_baseline(scene);
    if (baseline <= 0) return std::nullopt;
    double near = 0.5 * view.camera.width_px / (focal_length_px(view.camera).x() * baseline);
    if (const auto centre = convergence_point(scene)) {
        constexpr double kNearestShare = 0.2;
        const double depth = (view.cam_from_world * *centre).z();
        if (depth > 0) near = std::min(near, 1.0 / (kNearestShare * depth));
    }
    return InverseDepthRange{0.0, near};
}

}  // namespace lumi
