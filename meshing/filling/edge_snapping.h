#pragma once

#include "calib/capture/image.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Moves the edges of surfaces to the edges of the photograph.
///
/// A matching window carries the nearer depth a few pixels beyond a silhouette. A pixel near a jump
/// in depth therefore asks the pixels around it which of the two surfaces they show, weighted by
/// how much they look like it (bilateral weights; the weighted mode of two, compare Ma et al.
/// 2013), and goes over to the surface that wins: its inverse depth and confidence are those of the
/// nearest pixel that voted for it. Pixels away from jumps stay.
///
/// A jump is more than three times `one_pixel`, the inverse depth that makes one pixel of
/// disparity. Where that is 0, no depth is known to jump, and all pixels stay.
///
/// So do those that `kept` has other than 0 (of the map's size; empty: none).
void snap_edges(DepthMap& map, const ColorImage& photograph, double one_pixel,
                const GrayImage& kept = {});

}  // namespace lumi
