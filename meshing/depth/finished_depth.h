#pragma once

#include <vector>

#include "meshing/depth/depth_model.h"
#include "meshing/depth/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// From what one view's photographs suggest to what is drawn: the last two steps of depth.

/// What the neighbours confirm of a view's estimate (cross_view_check.h), without islands smaller
/// than 0.05 % of the picture; the estimate itself where it needs no confirmation.
[[nodiscard]] DepthMap confirmed_depth(const DepthScene& scene,
                                       const std::vector<DepthEstimate>& estimates, int view_index);

/// Gives every pixel of `map`, view `view_index` among the confirmed maps, an inverse depth: what
/// is unknown is filled along the photograph's edges from what is known around it, and what is
/// known ends where the photograph does (edge_aware_fill.h, edge_snapping.h).
void fill_unknown_depth(const DepthScene& scene, const std::vector<DepthMap>& confirmed_maps,
                        int view_index, DepthMap& map);

}  // namespace lumi
