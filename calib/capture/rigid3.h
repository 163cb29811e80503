#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace lumi {

/// A rotation and a translation: `cam_from_world * point_in_world` is the point in the camera.
struct Rigid3 {
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
        return rotation * point + translation;
    }

    friend bool operator==(const Rigid3&, const Rigid3&) = default;
};

[[nodiscard]] inline Rigid3 inverse(const Rigid3& b_from_a) {
    const Eigen::Quaterniond a_from_b = b_from_a.rotation.conjugate();
    return {a_from_b, -(a_from_b * b_from_a.translation)};
}

/// `c_from_b * b_from_a`: adjacent frames cancel.
[[nodiscard]] inline Rigid3 operator*(const Rigid3& c_from_b, const Rigid3& b_from_a) {
    return {(c_from_b.rotation * b_from_a.rotation).normalized(),
            c_from_b.rotation * b_from_a.translation + c_from_b.translation};
}

/// Whether all numbers are finite and the quaternion has length one, to what a file's decimals
/// keep.
[[nodiscard]] inline bool is_rigid(const Rigid3& b_from_a) {
    constexpr double kUnitTolerance = 1e-6;
    return b_from_a.translation.allFinite() &&
           std::abs(b_from_a.rotation.norm() - 1) <= kUnitTolerance;
}

/// Where the camera's optical centre stands.
[[nodiscard]] inline Eigen::Vector3d centre_in_world(const Rigid3& cam_from_world) {
    return inverse(cam_from_world).translation;
}

/// The direction the camera looks along (its +z axis), of length one.
[[nodiscard]] inline Eigen::Vector3d optical_axis_in_world(const Rigid3& cam_from_world) {
    return cam_from_world.rotation.conjugate() * Eigen::Vector3d::UnitZ();
}

/// The rotation by the smallest angle that turns the direction `from` to the direction `to`.
[[nodiscard]] Eigen::Quaterniond turn_between(const Eigen::Vector3d& from,
                                              const Eigen::Vector3d& to);

}  // namespace lumi
