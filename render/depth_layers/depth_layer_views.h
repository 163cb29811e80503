#pragma once

#include <vector>

#include "render/view_choice/depth_view_choice.h"

namespace lumi {

/// Which view each depth layer shows to texels of each set: `[set][layer]`, kNoView for none. A
/// view that several sets have in common is in the same layer wherever that can be.
using DepthLayerViews = std::vector<std::vector<int>>;

/// No set may have more views than there are layers.
[[nodiscard]] DepthLayerViews depth_layer_views(const std::vector<DepthViewSet>& sets, int layers);

}  // namespace lumi
