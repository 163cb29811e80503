#pragma once

#include <Eigen/Core>
#include <istream>
#include <string>
#include <vector>

namespace lumi {

/// The next nine numbers, by rows; the stream tells when there are none.
[[nodiscard]] Eigen::Matrix3d next_matrix(std::istream& stream);

/// The parameters of LensModel::kPinhole for K of a file that counts pixels from pixel centres.
/// Throws Error (E-IMPORT-POSES) unless K is (fx 0 cx, 0 fy cy, 0 0 1), with fx and fy > 0; `where`
/// begins the message.
[[nodiscard]] std::vector<double> pinhole_parameters(const Eigen::Matrix3d& calibration,
                                                     const std::string& where);

}  // namespace lumi
