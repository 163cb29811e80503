#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "calib/capture/rigid3.h"

namespace lumi {

/// How a file of poses is refused: E-IMPORT-POSES, with its place and what was expected.
[[noreturn]] void refuse_poses(const std::string& where, const std::string& what);

/// The pose of a camera whose axes (+x right, +y down, +z forward) are the columns of
/// `world_from_cam` and whose centre is in world units. Throws Error (E-IMPORT-POSES) unless
/// everything is finite and the matrix is a rotation up to rounding; `where` begins the message.
[[nodiscard]] Rigid3 pose_from_axes(const Eigen::Matrix3d& world_from_cam,
                                    const Eigen::Vector3d& centre_in_world,
                                    const std::string& where);

}  // namespace lumi
