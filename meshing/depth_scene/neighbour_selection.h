#pragma once

#include <vector>

#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// For each view at most `max_neighbours` others to compare it with, best first.
///
/// A pair scores the sum, over the points both see, of a weight by the angle at which the two
/// lines of sight meet: largest at 6 degrees, falling fast towards no parallax and slowly towards
/// views that look different (after MVSNet, Yao et al. 2018, section 4.1); less where one of them
/// sees the point larger, as one that is ahead on a walk does. A view without tracks
/// takes a grid of its pixels at the harmonic mean of its range in place of points. Neighbours are
/// taken greedily, and one that stands in the direction of an earlier one counts less, so that what
/// one side cannot see is seen from another. Ties go to the lower index.
[[nodiscard]] std::vector<std::vector<int>> select_neighbours(const DepthScene& scene,
                                                              int max_neighbours);

}  // namespace lumi
