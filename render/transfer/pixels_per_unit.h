#pragma once

#include <Eigen/Core>

#include "calib/capture/camera.h"
#include "calib/capture/rigid3.h"

namespace lumi {

/// Pixels for each unit of length at a point, as a camera sees it; 0 at the camera itself.
[[nodiscard]] double pixels_per_unit(const Camera& camera, const Rigid3& cam_from_world,
                                     const Eigen::Vector3d& point_in_world);

}  // namespace lumi
