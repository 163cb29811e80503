#include "calib/known_poses/camera_axes.h"

#include <Eigen/LU>

#include "calib/work/error.h"

namespace lumi {

void refuse_poses(const std::string& where, const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-IMPORT-POSES", where + ": " + what,
                "write the poses again with the program they come from");
}

Rigid3 pose_from_axes(const Eigen::Matrix3d& world_from_cam, const Eigen::Vector3d& centre_in_world,
                      const std::string& where) {
    // Files carry as few as six digits.
    constexpr double kRoundingTolerance = 1e-3;
    if (!world_from_cam.allFinite() || !centre_in_world.allFinite()) {
        refuse_poses(where, "the pose is not finite");
    }
    if (!(world_from_cam.transpose() * world_from_cam).isIdentity(kRoundingTolerance)) {
        refuse_poses(where, "the camera's axes are not of length one and at right angles");
    }
    if (world_from_cam.determinant() < 0) refuse_poses(where, "the camera's axes are mirrored");
    Rigid3 world_from_camera;
    world_from_camera.rotation = Eigen::Quaterniond(world_from_cam).normalized();
    world_from_camera.translation = centre_in_world;
    return inverse(world_from_camera);
}

}  // namespace lumi
