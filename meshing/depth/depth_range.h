#pragma once

#include <optional>

#include "meshing/depth/depth_scene.h"

namespace lumi {

/// The range of inverse depth of view `index`.
///
/// With scene points in the picture: their 1st to 99th percentile, widened to twice the distance
/// of the farthest and two thirds of the distance of the nearest. With too few: from infinity to
/// where the nearest camera would lose sight of half its picture, but no nearer than a fifth of
/// the way to the point where the optical axes meet, if they do. Empty when all cameras stand in
/// one place: nothing then tells depth.
[[nodiscard]] std::optional<InverseDepthRange> inverse_depth_range(const DepthScene& scene,
                                                                   int index);

/// The point nearest to all optical axes (least squares). Empty when the axes are parallel.
[[nodiscard]] std::optional<Eigen::Vector3d> convergence_point(const DepthScene& scene);

}  // namespace lumi
