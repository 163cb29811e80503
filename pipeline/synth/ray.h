#pragma once

#include <Eigen/Core>

namespace lumi {

/// A half-line in the world; `direction` is of length one, so that its parameter is a distance.
struct Ray {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();

    [[nodiscard]] Eigen::Vector3d at(double distance) const {
        return origin + distance * direction;
    }
};

/// The stretch of a ray between two distances; empty when `far < near`.
struct RaySpan {
    double near = 0.0;
    double far = 0.0;
    [[nodiscard]] bool empty() const { return !(near <= far); }
};

}  // namespace lumi
