#pragma once

#include <vector>

#include "calib/adjust/camera_blocks.h"

namespace lumi {

/// Seven degrees of freedom (place, attitude, size of the world) are free in an adjustment: holds
/// the first of `poses` that the problem has, and one coordinate of the one whose centre is
/// farthest from it. `cameras` was made of the same poses.
void hold_gauge(ceres::Problem& problem, const std::vector<Rigid3>& poses, CameraBlocks& cameras);

}  // namespace lumi
