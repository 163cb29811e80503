#pragma once

#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Eyes along a path that comes to all that may pop, `count` of them at even steps: from the view
/// nearest to the middle of the capture through others to the one farthest out, on past the border
/// by a third of that turn about the scene's centre, back behind the camera mesh, and through the
/// mesh towards the scene, by a third of its near depth. It leads around the scene's centre: within
/// what stands there no picture is right, and its surface is where the scene itself jumps. Every
/// eye has the first view's field of view at the given size: the whole photograph fits.
[[nodiscard]] std::vector<Eye> path_past_border(const Lumigraph& lumigraph, int count, int width_px,
                                                int height_px);

}  // namespace lumi
