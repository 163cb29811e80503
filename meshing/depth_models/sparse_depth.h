#pragma once

#include <vector>

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Depth from a view's triangulated points alone: a Delaunay triangulation of their pixels,
/// interpolated in inverse depth, which is affine in the picture on each plane.
///
/// Points that differ from the median of their ring by more than 3 MAD are dropped first. The
/// picture's border gets points of its own, each with the mean of its six nearest points weighted
/// by inverse squared distance, so that the map reaches the border and stays within what was seen.
/// One point gives a constant, two and three blend between them by the same rule. Without points
/// the map is the middle of the view's range. Confidence is kMostByPoints at a point and
/// falls with the distance to the nearest one; kUnseen without points.
[[nodiscard]] DepthMap sparse_depth(const DepthView& view);

/// The same, led along the edges of the photograph: points hold their place, the triangulation
/// holds weakly, and between them the Fast Global Smoother (guided_smoothing.h) lets inverse depth
/// change where the photograph does.
[[nodiscard]] DepthMap filled_sparse_depth(const DepthView& view);

/// Of each point whether it agrees with the ring of points around it, to `smallest_difference` of
/// inverse depth or what rings usually differ by. Fewer than 8 all do: a ring of so few does not
/// tell who is wrong.
[[nodiscard]] std::vector<char> agree_with_surroundings(const std::vector<SparsePoint>& points,
                                                        double smallest_difference);

/// The points that do, in their order.
[[nodiscard]] std::vector<SparsePoint> without_outliers(const std::vector<SparsePoint>& points,
                                                        double smallest_difference);

}  // namespace lumi
