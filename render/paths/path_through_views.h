#pragma once

#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Eyes along a path from view to view in their order, `count` of them at even steps: centres run
/// straight between the views, rotations turn evenly, and all stand upright (photograph_eye.h).
/// Every eye has the first view's field of view at the given size: the whole photograph fits.
[[nodiscard]] std::vector<Eye> path_through_views(const Lumigraph& lumigraph, int count,
                                                  int width_px, int height_px);

}  // namespace lumi
