#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <concepts>
#include <optional>

#include "calib/capture/camera.h"
#include "calib/capture/rigid3.h"

namespace lumi {

/// A point as the view it is warped to sees it.
struct WarpedPixel {
    Eigen::Vector2d pixel;
    double inverse_depth;  ///< In that view.
    double depth_ratio;    ///< Its depth in that view over its depth in the view it comes from.

    /// Of a homogeneous pixel whose third entry is that ratio; empty where the point is not in
    /// front of the view. The pixel may lie outside the picture.
    [[nodiscard]] static std::optional<WarpedPixel> of(const Eigen::Vector3d& place,
                                                       double inverse_depth_at_source) {
        if (!(place.z() > 0)) return std::nullopt;
        return WarpedPixel{place.hnormalized(), inverse_depth_at_source / place.z(), place.z()};
    }
};

/// Where a pixel of view `a`, at an inverse depth there, appears in view `b`; pinhole cameras.
///
/// Homogeneous pixel in b = infinite_homography * (x, y, 1) + inverse_depth_a * epipole (Hartley
/// and Zisserman, eq. 13.2, with the plane parallel to a's image; Faugeras and Luong, The Geometry
/// of Multiple Images, the plane at infinity). Its third entry is z_b / z_a, so that
/// inverse_depth_b = inverse_depth_a / third entry. Inverse depths are in one over the unit of the
/// world, whichever that is. Holds for points at infinity, too.
struct InverseDepthWarp {
    Eigen::Matrix3d infinite_homography = Eigen::Matrix3d::Identity();  ///< K_b R K_a^-1.
    Eigen::Vector3d epipole = Eigen::Vector3d::Zero();                  ///< K_b t: a's centre in b.

    /// The homogeneous pixel in b.
    [[nodiscard]] Eigen::Vector3d homogeneous_at(const Eigen::Vector2d& pixel_a,
                                                 double inverse_depth_a) const {
        return infinite_homography * pixel_a.homogeneous() + inverse_depth_a * epipole;
    }

    /// Empty where the point is not in front of b.
    [[nodiscard]] std::optional<WarpedPixel> at(const Eigen::Vector2d& pixel_a,
                                                double inverse_depth_a) const {
        return WarpedPixel::of(homogeneous_at(pixel_a, inverse_depth_a), inverse_depth_a);
    }

    /// From a to b for points of a plane, as homogeneous pixels: their inverse depth in a is
    /// plane_inverse_depth . (x, y, 1).
    [[nodiscard]] Eigen::Matrix3d homography_of(const Eigen::Vector3d& plane_inverse_depth) const {
        return infinite_homography + epipole * plane_inverse_depth.transpose();
    }
};

/// Of a point's depth in b over that in a: with less it is taken to lie behind b, where a picture
/// is drawn of what is warped.
inline constexpr double kLeastDepthRatio = 1e-6;

/// A pinhole camera and where it stands. Refers to both: it is for passing them on only.
struct PosedCamera {
    const Camera& camera;
    const Rigid3& cam_from_world;

    PosedCamera(const Camera& of, const Rigid3& of_from_world)
        : camera(of), cam_from_world(of_from_world) {}

    /// Of whatever has both: a view, an eye.
    template <class Posed>
    requires requires(const Posed& posed) {
        { posed.camera } -> std::same_as<const Camera&>;
        { posed.cam_from_world } -> std::same_as<const Rigid3&>;
    }
    PosedCamera(const Posed& posed) : PosedCamera(posed.camera, posed.cam_from_world) {}
};

/// One half of `warp_from(a).to(b)`.
class WarpSource {
 public:
    explicit WarpSource(const PosedCamera& a) : a_(a) {}

    /// From pixels of the source to those of b.
    [[nodiscard]] InverseDepthWarp to(const PosedCamera& b) const;

 private:
    PosedCamera a_;
};

/// `const InverseDepthWarp b_from_a = warp_from(a).to(b)`.
[[nodiscard]] inline WarpSource warp_from(const PosedCamera& a) { return WarpSource(a); }

}  // namespace lumi
