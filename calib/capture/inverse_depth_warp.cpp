#include "calib/capture/inverse_depth_warp.h"

#include <Eigen/LU>

#include "calib/capture/calibration_matrix.h"

namespace lumi {

InverseDepthWarp WarpSource::to(const PosedCamera& b) const {
    const Rigid3 b_from_a = b.cam_from_world * inverse(a_.cam_from_world);
    const Eigen::Matrix3d calibration_b = calibration_matrix(b.camera);
    return {calibration_b * b_from_a.rotation.toRotationMatrix() *
                calibration_matrix(a_.camera).inverse(),
            calibration_b * b_from_a.translation};
}

}  // namespace lumi
