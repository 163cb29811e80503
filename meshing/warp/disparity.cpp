#include "meshing/warp/disparity.h"

namespace lumi {

double disparity_per_inverse_depth(const InverseDepthWarp& b_from_a, const Eigen::Vector2d& pixel_a,
                                   double inverse_depth_a) {
    const Eigen::Vector3d p = b_from_a.homogeneous_at(pixel_a, inverse_depth_a);
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
    const double share = b_from_a.homogeneous_at(pixel_a, inverse_depth_a).z();
    const double share_at_infinity = b_from_a.homogeneous_at(pixel_a, 0).z();
    if (share >= kLeastDepthShare || share_at_infinity <= kLeastDepthShare) return inverse_depth_a;
    return inverse_depth_a * (share_at_infinity - kLeastDepthShare) / (share_at_infinity - share);
}

}  // namespace lumi
