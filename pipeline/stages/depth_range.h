#pragma once

#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Depths between which the scene lies, in world units.
struct DepthRange {
    double near_depth = 0.0;
    double far_depth = 0.0;
};

/// The 1st and 99th percentile of the depths that the views are sure of; of all their depths when
/// they are sure of none; zeros when they have no depth at all.
[[nodiscard]] DepthRange depth_range_of(const std::vector<LumigraphView>& views);

}  // namespace lumi
