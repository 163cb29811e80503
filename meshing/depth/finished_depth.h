#pragma once

#include <optional>
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

/// By how many pixels of disparity what is continued beyond all that is known should recede, for
/// each pixel of its distance (receding_fill.h); up to 32 views are asked, evenly over the
/// capture, of what `masks` (view_mask.h) leave in the scene. 0: not at all; empty: too few can
/// tell.
[[nodiscard]] std::optional<double> fill_recession(const DepthScene& scene,
                                                   const std::vector<GrayImage>& masks,
                                                   const std::vector<DepthMap>& confirmed_maps,
                                                   const std::vector<DepthEstimate>& estimates,
                                                   int threads);

/// Gives every pixel of `map`, view `view_index` among the confirmed maps, an inverse depth: what
/// is unknown is filled along the photograph's edges from what is known around it, or recedes from
/// it by `recession_px`, and what is known ends where the photograph does (edge_aware_fill.h,
/// edge_snapping.h).
void fill_unknown_depth(const DepthScene& scene, const std::vector<DepthMap>& confirmed_maps,
                        int view_index, double recession_px, DepthMap& map);

}  // namespace lumi
