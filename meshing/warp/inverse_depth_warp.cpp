#include "meshing/warp/inverse_depth_warp.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace lumi {
namespace {

Eigen::Matrix3d calibration_matrix(const Camera& camera) {
    const Eigen::Vector2d focal = focal_length_px(camera);
    const Eigen::Vector2d centre = principal_point_px(camera);
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    matrix.diagonal().head<2>() = focal;
    matrix.topRightCorner<2, 1>() = centre;
    return matrix;
}

}  // namespace

InverseDepthWarp warp_b_from_a(const Camera& camera_a, const Rigid3& a_from_world,
                               const Camera& camera_b, const Rigid3& b_from_world) {
    const Rigid3 b_from_a = b_from_world * inverse(a_from_world);
    const Eigen::Matrix3d calibration_b = calibration_matrix(camera_b);
    return {calibration_b * b_from_a.rotation.toRotationMatrix() *
                calibration_matrix(camera_a).inverse(),
            calibration_b * b_from_a.translation};
}

double disparity_per_inverse_depth(const InverseDepthWarp& b_from_a, const Eigen::Vector2d& pixel_a,
                                   double inverse_depth_a) {
    const Eigen::Vector3d p = b_from_a(pixel_a, inverse_depth_a);
    if (p.z() <= 0) return 0.0;
    // Derivative of (p.x, p.y) / p.z by the inverse depth.
    return ((b_from_a.epipole.head<2>() * p.z() - p.head<2>() * b_from_a.epipole.z()) /
            (p.z() * p.z()))
        .norm();
}

double comparable_inverse_depth(const InverseDepthWarp& b_from_a, const Eigen::Vector2d& pixel_a,
                                double inverse_depth_a) {
    constexpr double kLeastDepthShare = 0.5;
    // The depth in b as a share of that in a, which falls linearly with inverse depth.
    const double share = b_from_a(pixel_a, inverse_depth_a).z();
    const double share_at_infinity = b_from_a(pixel_a, 0).z();
    if (share >= kLeastDepthShare || share_at_infinity <= kLeastDepthShare) return inverse_depth_a;
    return inverse_depth_a * (share_at_infinity - kLeastDepthShare) / (share_at_infinity - share);
}

}  // namespace lumi
