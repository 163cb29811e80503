#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/capture/capture.h"

namespace lumi {

/// Where the scene is, as far as the listed views tell.
struct SceneExtent {
    Eigen::Vector3d centre_in_world = Eigen::Vector3d::Zero();
    double radius = 0.0;      ///< Holds 90 % of the scene points; 0 when there are none.
    bool inside_out = false;  ///< The cameras stand in the middle and look outwards.
    std::vector<Eigen::Vector3d> points_in_world;  ///< Those that two or more listed views see.
};

/// The point that the optical axes come nearest to, when they converge in front of the cameras;
/// otherwise the median of the scene points; otherwise a point ahead of the cameras at a distance
/// of their spread.
[[nodiscard]] SceneExtent find_scene(const Capture& capture, const std::vector<int>& view_indices);

}  // namespace lumi
