#pragma once

#include <vector>

#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// The view's neighbours, best first, and then theirs: what lies beside its picture, or is hidden
/// from all of its neighbours, may still be seen by one of theirs.
[[nodiscard]] std::vector<int> views_around(const DepthScene& scene, int view_index);

}  // namespace lumi
