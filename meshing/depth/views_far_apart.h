#pragma once

#include <vector>

#include "meshing/depth/depth_scene.h"

namespace lumi {

/// At most `count` of the candidates: the first, and then always the one whose camera stands
/// farthest from those before (Gonzalez 1985).
[[nodiscard]] std::vector<int> views_far_apart(const DepthScene& scene, std::vector<int> candidates,
                                               std::size_t count);

}  // namespace lumi
