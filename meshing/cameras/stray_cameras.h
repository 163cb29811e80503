#pragma once

#include <vector>

#include "meshing/cameras/scene_centre.h"

namespace lumi {

/// The cameras without strays: few (a tenth at most, or one) that stand more than twice as far from
/// the scene as the median camera, or less than half as far, such as one step back for an overview.
/// All cameras where there are more of those, or where fewer than three would be left.
[[nodiscard]] std::vector<OpticalAxis> without_strays(const std::vector<OpticalAxis>& axes);

}  // namespace lumi
