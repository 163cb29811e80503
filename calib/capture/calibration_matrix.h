#pragma once

#include <Eigen/Core>

#include "calib/capture/camera.h"

namespace lumi {

/// The calibration matrix K of a pinhole camera (Hartley and Zisserman, eq. 6.4, without skew):
/// pixel = K * point in the camera, homogeneous. Pixels are counted as Camera counts them.
[[nodiscard]] Eigen::Matrix3d calibration_matrix(const Camera& camera);

}  // namespace lumi
