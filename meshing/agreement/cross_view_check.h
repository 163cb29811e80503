#pragma once

#include <vector>

#include "meshing/depth_scene/depth_estimate.h"
#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// What view `view_index` may keep of its claim after its neighbours were asked.
///
/// A pixel is carried to a neighbour by its inverse depth, and back by the inverse depth found
/// there; when it returns within one pixel and both claim to know, they agree (Hirschmueller 2008,
/// section 2.4, for posed views). What moves less for a neighbour than for the fastest one has to
/// return closer, within two pixels of that one's disparity, and a neighbour without parallax
/// (parallax.h) is not asked. Confidence becomes that of the number of those that agree
/// (confidence_of_support). Where views agree the inverse depth is the mean of what they say, so
/// that all describe nearly one surface.
[[nodiscard]] DepthMap cross_view_check(const DepthScene& scene,
                                        const std::vector<DepthEstimate>& estimates,
                                        int view_index);

/// Takes the confidence from connected patches of fewer than `min_pixels` pixels; neighbouring
/// pixels are connected when their inverse depths differ by at most `max_step`.
void remove_speckles(DepthMap& map, double max_step, int min_pixels);

}  // namespace lumi
