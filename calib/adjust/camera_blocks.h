#pragma once

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/capture/rigid3.h"

namespace lumi {

/// A pose cam_from_world as one parameter block: the quaternion (x, y, z, w), then the translation.
/// Eliminating points couples every block that sees one with every other: one block a view halves
/// what that costs against a block for the rotation and one for the translation.
using PoseBlock = std::array<double, 7>;

[[nodiscard]] inline PoseBlock pose_block(const Rigid3& pose) {
    const Eigen::Quaterniond& q = pose.rotation;
    const Eigen::Vector3d& t = pose.translation;
    return {q.x(), q.y(), q.z(), q.w(), t.x(), t.y(), t.z()};
}

/// The pose again, its quaternion of unit length.
[[nodiscard]] inline Rigid3 pose_of(const PoseBlock& block) {
    return {Eigen::Quaterniond(block[3], block[0], block[1], block[2]).normalized(),
            {block[4], block[5], block[6]}};
}

/// Six degrees of freedom. The caller owns it (Ceres takes it over).
[[nodiscard]] inline ceres::Manifold* new_pose_manifold() {
    return new ceres::ProductManifold<ceres::EigenQuaternionManifold, ceres::EuclideanManifold<3>>;
}

/// Five: one coordinate of the translation stays as it is.
[[nodiscard]] inline ceres::Manifold* new_pose_manifold_without(int axis) {
    return new ceres::ProductManifold<ceres::EigenQuaternionManifold, ceres::SubsetManifold>(
        ceres::EigenQuaternionManifold{}, ceres::SubsetManifold(3, {axis}));
}

/// The poses of all views and the parameters of all lenses, each one after another. Ceres orders
/// parameter blocks by address: in one piece of memory the order, and with it every rounding, is
/// the same in every run. (Points lie in one piece already.)
class CameraBlocks {
 public:
    CameraBlocks(const std::vector<Rigid3>& poses, const std::vector<Camera>& lenses) {
        for (const Rigid3& pose : poses) poses_.push_back(pose_block(pose));
        for (const Camera& lens : lenses) {
            offsets_.push_back(lenses_.size());
            lenses_.insert(lenses_.end(), lens.parameters.begin(), lens.parameters.end());
        }
    }
    [[nodiscard]] double* pose(std::size_t view) { return poses_[view].data(); }
    [[nodiscard]] double* lens(std::size_t camera) { return lenses_.data() + offsets_[camera]; }

    [[nodiscard]] Rigid3 solved_pose(std::size_t view) const { return pose_of(poses_[view]); }
    void copy_lenses_to(std::vector<Camera>& lenses) const {
        for (std::size_t index = 0; index < lenses.size(); ++index) {
            std::copy_n(lenses_.begin() + static_cast<std::ptrdiff_t>(offsets_[index]),
                        lenses[index].parameters.size(), lenses[index].parameters.begin());
        }
    }

 private:
    std::vector<PoseBlock> poses_;
    std::vector<double> lenses_;
    std::vector<std::size_t> offsets_;
};

}  // namespace lumi
