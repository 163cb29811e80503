#pragma once

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// One inverse depth for the whole view: the median of its points, or without points the middle of
/// its range.
[[nodiscard]] DepthMap plane_depth(const DepthView& view);

/// One plane for the whole view, at any slant: inverse depth affine in the picture, fitted to the
/// points by least squares whose weights fall with the residual (Cauchy; the scale is the median
/// residual, from the median plane on). Fewer than six points give `plane_depth`.
///
/// Inverse depth never falls below 0: beyond its horizon a plane is infinitely far.
[[nodiscard]] DepthMap slanted_plane_depth(const DepthView& view);

}  // namespace lumi
