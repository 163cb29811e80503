#pragma once

#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// How many views' depths are compared at each pixel: enough for two to outvote one, and for what
/// one does not see.
inline constexpr int kMaxDepthViews = 4;

/// The views, best first and at most `max_views`, whose depth is most use to the eye: those that
/// see what it sees from nearly the same direction.
///
/// Each view is scored on a grid of the eye's pixels, placed on the scene plane (scene_plane.h):
/// for each that lies in its photograph, more the smaller the angle between the view and the eye. A
/// view that sees none of them is left out unless all are.
[[nodiscard]] std::vector<int> choose_depth_views(const Lumigraph& lumigraph, const Eye& eye,
                                                  int max_views);

}  // namespace lumi
