#include "render/transfer/scene_plane.h"

#include <Eigen/LU>
#include <algorithm>

#include "calib/capture/calibration_matrix.h"

namespace lumi {

Eigen::Vector3d scene_plane_inverse_depth(const Lumigraph& lumigraph, const Eye& eye) {
    const Eigen::Vector3d centre_in_eye = eye.cam_from_world * lumigraph.mesh.scene_centre_in_world;
    const double to_centre = centre_in_eye.norm();
    const double near = lumigraph.near_depth;
    // An eye that has come closer than the scene's near end stays that far from the plane. Close to
    // the centre, which the plane turns about, it recedes to infinity, so that no picture jumps.
    constexpr double kTurningShare = 0.125;
    const double distance = std::max(to_centre, near);
    const double length = std::max(to_centre, kTurningShare * near);
    if (!(distance > 0)) return Eigen::Vector3d::Zero();
    const Eigen::Vector3d normal = centre_in_eye / length;
    // A ray d of unit depth meets the plane normal . X = distance at depth distance / (normal . d).
    return calibration_matrix(eye.camera).inverse().transpose() * normal / distance;
}

}  // namespace lumi
