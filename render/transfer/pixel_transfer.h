#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "calib/capture/camera.h"
#include "calib/capture/rigid3.h"

namespace lumi {

/// The pinhole matrix K of a camera: pixel = K * point, homogeneous.
[[nodiscard]] Eigen::Matrix3d pinhole_matrix(const Camera& camera);

/// Where a pixel of one view lies in another, for a known inverse depth: a homography and a
/// parallax (Faugeras, Luong: the plane at infinity and the epipole).
///
/// With q the inverse depth in the source, `at_infinity * (x, y, 1) + q * per_inverse_depth` is the
/// homogeneous pixel of the target, and q divided by its third coordinate is the inverse depth
/// there. Holds for q = 0, too.
struct PixelTransfer {
    Eigen::Matrix3d at_infinity = Eigen::Matrix3d::Identity();
    Eigen::Vector3d per_inverse_depth = Eigen::Vector3d::Zero();

    /// The homogeneous pixel of the target.
    [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector2d& pixel, double inverse_depth) const {
        return at_infinity * pixel.homogeneous() + inverse_depth * per_inverse_depth;
    }
};

/// Of a point's depth in the target over that in the source: with less it is taken to lie behind
/// the target.
inline constexpr double kLeastDepthRatio = 1e-6;

[[nodiscard]] PixelTransfer pixel_transfer(const Camera& target, const Rigid3& target_from_world,
                                           const Camera& source, const Rigid3& source_from_world);

}  // namespace lumi
