#pragma once

#include <Eigen/Core>

#include "calib/capture/inverse_depth_warp.h"

namespace lumi {

/// Pixels that a point seen at `pixel_a` moves by in view b for each unit of inverse depth. Zero
/// where the point is behind b.
[[nodiscard]] double disparity_per_inverse_depth(const InverseDepthWarp& b_from_a,
                                                 const Eigen::Vector2d& pixel_a,
                                                 double inverse_depth_a);

/// The inverse depth itself, or the largest at which b, which is ahead, sees the point at no less
/// than half its depth in a. A camera ahead sees what it is about to pass move without bound, and
/// nothing of what it has passed.
[[nodiscard]] double comparable_inverse_depth(const InverseDepthWarp& b_from_a,
                                              const Eigen::Vector2d& pixel_a,
                                              double inverse_depth_a);

}  // namespace lumi
