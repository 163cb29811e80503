#include "meshing/depth_scene/depth_range.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "calib/work/median.h"
#include "meshing/warp/parallax.h"

namespace lumi {
namespace {

constexpr std::size_t kMinPoints = 12;

/// Every scene point inside the picture, whether or not this view's track found it.
std::vector<SparsePoint> points_inside(const DepthScene& scene, const DepthView& view) {
    std::vector<SparsePoint> points;
    for (const ScenePoint& point : scene.points) {
        const Eigen::Vector3d in_cam = view.cam_from_world * point.position_in_world;
        const auto pixel = project(view.camera, in_cam);
        if (pixel && is_inside(view.camera, *pixel)) points.push_back({*pixel, 1.0 / in_cam.z()});
    }
    return points;
}

/// Inverse depths within this ratio are alike.
constexpr double kLikeRatio = 1.25;

/// Whether at least five others lie beside it at like depths.
bool is_of_a_patch(const SparsePoint& point, const std::vector<SparsePoint>& points,
                   const Camera& camera) {
    constexpr double kBesideShareOfLongerSide = 0.1;
    constexpr std::ptrdiff_t kLeastPoints = 6;
    const double beside_px = kBesideShareOfLongerSide * std::max(camera.width_px, camera.height_px);
    const auto alike = std::count_if(points.begin(), points.end(), [&](const SparsePoint& other) {
        const double ratio = other.inverse_depth / point.inverse_depth;
        return ratio < kLikeRatio && ratio * kLikeRatio > 1 &&
               (other.pixel - point.pixel).norm() < beside_px;
    });
    return alike >= kLeastPoints;
}

/// The inverse depth of the nearest patch of points, of those nearer than `bound`; empty: of none.
std::optional<double> nearest_patch(const std::vector<SparsePoint>& points, double bound,
                                    const Camera& camera) {
    // Of the many points of a scene few are so near, and only these are compared with each other.
    std::vector<SparsePoint> near;
    std::copy_if(points.begin(), points.end(), std::back_inserter(near),
                 [&](const auto& point) { return point.inverse_depth * kLikeRatio > bound; });
    std::optional<double> nearest;
    for (const SparsePoint& point : near) {
        if (point.inverse_depth > nearest.value_or(bound) && is_of_a_patch(point, near, camera))
            nearest = point.inverse_depth;
    }
    return nearest;
}

InverseDepthRange range_of(const std::vector<SparsePoint>& points, const Camera& camera) {
    constexpr double kTail = 0.01;
    constexpr double kWidened = 1.5;
    /// Points of a patch are near its surface; strays beyond them do not count.
    constexpr double kPatchWidened = 1.1;
    std::vector<double> inverse_depths;
    for (const SparsePoint& point : points) inverse_depths.push_back(point.inverse_depth);
    const double near = kWidened * quantile_of(std::move(inverse_depths), 1 - kTail);
    const auto patch = nearest_patch(points, near / kPatchWidened, camera);
    return {0.0, patch ? kPatchWidened * *patch : near};
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
    const std::vector<SparsePoint> points = points_inside(scene, view);
    if (points.size() >= kMinPoints) return range_of(points, view.camera);

    std::vector<Eigen::Vector3d> centres;
    for (const DepthView& other : scene.views)
        centres.push_back(centre_in_world(other.cam_from_world));
    const double baseline = typical_baseline(centres);
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
