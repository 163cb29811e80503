#pragma once

#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// How many views' depths are compared at each pixel: enough for two to outvote one, and for what
/// one does not see.
inline constexpr int kMaxDepthViews = 4;

/// The views, at most `max_views`, whose depth is most use to the eye: those that see what it sees
/// from nearly the same direction, and together all of it.
///
/// The eye's picture is sampled on a grid, placed on the scene plane (scene_plane.h) and again at
/// the scene's near end, for less: a view whose photograph holds a ray's far part alone cannot tell
/// what stands before it. Views are taken one by one; each adds, for every sample in its
/// photograph, the more the smaller the angle between view and eye, and the less the more views see
/// it already. The first is the nearest. Views that see nothing of it are left out, unless all are.
[[nodiscard]] std::vector<int> choose_depth_views(const Lumigraph& lumigraph, const Eye& eye,
                                                  int max_views);

}  // namespace lumi
