#pragma once

#include <optional>

#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// The range of inverse depth of view `index`.
///
/// From infinity, which costs few planes and holds what no point told of (a strip of background,
/// the sky), to two thirds of the distance of the nearest scene point in the picture, one in a
/// hundred left out; or nearer, to where scene points lie beside each other at like depths: a post
/// that is small in the picture has few points, but they agree, as strays do not. With too few
/// points: to where the nearest camera would lose sight of half its
/// picture, but no nearer than a fifth of the way to the point where the optical axes meet, if they
/// do. Empty when all cameras stand in one place: nothing then tells depth.
[[nodiscard]] std::optional<InverseDepthRange> inverse_depth_range(const DepthScene& scene,
                                                                   int index);

/// The point nearest to all optical axes (least squares). Empty when the axes are parallel.
[[nodiscard]] std::optional<Eigen::Vector3d> convergence_point(const DepthScene& scene);

}  // namespace lumi
