#pragma once

#include <vector>

#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// At most `count` of the candidates: the first, and then always the one whose camera stands
/// farthest from those before (farthest_first.h).
[[nodiscard]] std::vector<int> views_far_apart(const DepthScene& scene,
                                               const std::vector<int>& candidates, int count);

}  // namespace lumi
