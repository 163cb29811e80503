#pragma once

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Depth of one view from pairs: the view and each neighbour are rectified (Bouguet's method),
/// matched by OpenCV's StereoSGBM (five paths), and what the pairs say is fused: of each pixel the
/// mean of the largest group that agrees within one pixel of the view's disparity.
///
/// Confidence is that of the number of pairs in the group (confidence_of_support).
/// Pairs that cannot be rectified are left out: cameras that look apart by more than 60 degrees, or
/// one in sight of the other (forward motion). Pictures are searched at most 256 pixels of
/// disparity deep; a pair that needs more is matched at half its size, and again.
[[nodiscard]] DepthMap pair_stereo(const DepthScene& scene, int view_index);

/// How many of the view's neighbours can be rectified with it.
[[nodiscard]] int rectifiable_pairs(const DepthScene& scene, int view_index);

}  // namespace lumi
