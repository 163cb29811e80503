#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/capture/capture.h"

namespace lumi {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// From the true pose of each view to its estimate, after the estimate's world was moved, turned
/// and scaled so that the true points' pictures differ least (all views alike): a rotation (rad)
/// that comes after the true pose, then what is added to its translation. That is the gauge in
/// which adjustment_covariance states uncertainty.
[[nodiscard]] std::vector<Vector6> aligned_pose_steps(const Capture& truth,
                                                      const Capture& estimate);

}  // namespace lumi
