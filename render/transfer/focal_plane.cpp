#include "render/transfer/focal_plane.h"

#include <Eigen/LU>

#include "calib/capture/calibration_matrix.h"

namespace lumi {

Eigen::Vector3d focal_plane_inverse_depth(const FocalPlane& plane, const Eye& eye) {
    const Rigid3& across = plane.cam_from_world.value_or(eye.cam_from_world);
    const double eye_to_plane = plane.depth - (across * centre_in_world(eye.cam_from_world)).z();
    if (eye_to_plane == 0) return Eigen::Vector3d::Zero();
    const Eigen::Vector3d normal_in_eye =
        eye.cam_from_world.rotation * optical_axis_in_world(across);
    // A ray d of unit depth meets the plane normal . X = eye_to_plane at depth
    // eye_to_plane / (normal . d).
    return calibration_matrix(eye.camera).inverse().transpose() * normal_in_eye / eye_to_plane;
}

}  // namespace lumi
