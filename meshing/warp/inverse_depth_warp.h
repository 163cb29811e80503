#pragma once

#include <Eigen/Core>

#include "calib/capture/camera.h"
#include "calib/capture/rigid3.h"

namespace lumi {

/// Where a pixel of view `a`, at an inverse depth there, appears in view `b`; pinhole cameras.
///
/// Homogeneous pixel in b = infinite_homography * (x, y, 1) + inverse_depth_a * epipole (Hartley
/// and Zisserman, eq. 13.2, with the plane parallel to a's image). Its third entry is
/// z_b / z_a, so that inverse_depth_b = inverse_depth_a / third entry. Nothing depends on the unit
/// of the world.
struct InverseDepthWarp {
    Eigen::Matrix3d infinite_homography;
    Eigen::Vector3d epipole;

    [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector2d& pixel_a,
                                             double inverse_depth_a) const {
        return infinite_homography * pixel_a.homogeneous() + inverse_depth_a * epipole;
    }
};

[[nodiscard]] InverseDepthWarp warp_b_from_a(const Camera& camera_a, const Rigid3& a_from_world,
                                             const Camera& camera_b, const Rigid3& b_from_world);

/// Pixels that a point seen at `pixel_a` moves by in view b for each unit of inverse depth. Zero
/// where the point is behind b.
[[nodiscard]] double disparity_per_inverse_depth(const InverseDepthWarp& b_from_a,
                                                 const Eigen::Vector2d& pixel_a,
                                                 double inverse_depth_a);

/// The inverse depth itself, or the largest at which b, which is ahead, sees the point at no less
/// than half its depth in a. A camera ahead sees what it is about to pass move without bound, and
/// nothing of what it has passed.
[[nodiscard]] double comparable_inverse_depth(const InverseDepthWarp& b_from_a,
                                              const Eigen::Vector2d& pixel_a,
                                              double inverse_depth_a);

}  // namespace lumi
