#pragma once

#include "calib/capture/rigid3.h"

namespace lumi {

/// Whether two cameras stand at one place, but for what rounding leaves.
[[nodiscard]] inline bool are_at_one_place(const Rigid3& first_from_world,
                                           const Rigid3& second_from_world) {
    constexpr double kRounding = 1e-9;
    const Eigen::Vector3d place = centre_in_world(first_from_world);
    return (centre_in_world(second_from_world) - place).norm() <= kRounding * (1 + place.norm());
}

}  // namespace lumi
