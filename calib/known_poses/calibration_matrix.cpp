#include "calib/known_poses/calibration_matrix.h"

#include <cmath>

#include "calib/known_poses/camera_axes.h"

namespace lumi {

Eigen::Matrix3d next_matrix(std::istream& stream) {
    Eigen::Matrix3d matrix;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) stream >> matrix(row, column);
    }
    return matrix;
}

std::vector<double> pinhole_parameters(const Eigen::Matrix3d& calibration,
                                       const std::string& where) {
    constexpr double kMaxSkew = 1e-3;
    const double focal_x = calibration(0, 0);
    const bool is_upper_triangular = calibration(1, 0) == 0 && calibration(2, 0) == 0 &&
                                     calibration(2, 1) == 0 && calibration(2, 2) == 1;
    if (!calibration.allFinite() || !is_upper_triangular || focal_x <= 0 ||
        calibration(1, 1) <= 0) {
        refuse_poses(where, "K is not a calibration matrix");
    }
    if (std::abs(calibration(0, 1)) > kMaxSkew * focal_x) refuse_poses(where, "K has a skew");
    // Our pixels are half a pixel further.
    constexpr double kHalfPixel = 0.5;
    return {focal_x, calibration(1, 1), calibration(0, 2) + kHalfPixel,
            calibration(1, 2) + kHalfPixel};
}

}  // namespace lumi
