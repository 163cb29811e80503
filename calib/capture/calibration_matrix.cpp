#include "calib/capture/calibration_matrix.h"

namespace lumi {

Eigen::Matrix3d calibration_matrix(const Camera& camera) {
    const Eigen::Vector2d focal = focal_length_px(camera);
    const Eigen::Vector2d centre = principal_point_px(camera);
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    matrix.diagonal().head<2>() = focal;
    matrix.topRightCorner<2, 1>() = centre;
    return matrix;
}

}  // namespace lumi
