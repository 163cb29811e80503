#pragma once

#include <ceres/ceres.h>

#include <Eigen/Core>
#include <memory>

#include "calib/capture/lens_model.h"

namespace lumi {

/// Pixel where a point is predicted minus pixel where it was seen, under a lens model known only at
/// run time, with its derivatives. Parameter blocks: lens, cam_from_world (PoseBlock), point in
/// world. There is no value when the point is not in front of the camera.
[[nodiscard]] std::unique_ptr<ceres::CostFunction> reprojection_cost(
    LensModel model, const Eigen::Vector2d& seen_at);

}  // namespace lumi
