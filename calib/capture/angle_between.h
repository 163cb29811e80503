#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace lumi {

/// The angle between two directions of any length, 0 to pi; also where it is tiny right to
/// rounding, which an arc cosine is not.
[[nodiscard]] inline double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace lumi
