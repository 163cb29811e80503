#pragma once

#include "calib/capture/image.h"
#include "meshing/agreement/surrounding_depth.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

// Every pixel of confidence 0 gets an inverse depth in two halves; known pixels and all confidences
// stay. `one_pixel` is the inverse depth that makes one pixel of disparity; 0 when there is no
// parallax.

/// The first half: the planes around are continued.
///
/// Where `surrounding` knows a pixel, that is taken. Any other unknown pixel looks for known ones
/// in eight directions, beyond the picture's border too, and continues the planes that it finds
/// there. What lies clearly before the farthest of them does not count: a hole beside an object is
/// mostly what the object hides, so it continues the background (Hirschmueller 2008, section 2.5).
/// The rest is weighted by nearness. Where nothing is known in any direction, `fallback` is taken.
///
/// Where other views know something that the photograph does not show (depth_of_others.h: `hidden`,
/// empty or of the map's size), only what lies clearly before that is continued, if anything does.
///
/// Returns how far from what is known those pixels lie that have known ones in at most half of the
/// directions; 0 for all others.
FloatImage continue_known_depth(DepthMap& map, const FloatImage& fallback, double one_pixel,
                                SurroundingDepth surrounding = {}, const DepthMap& hidden = {});

/// The second half: what was filled is smoothed along the photograph's edges (Fast Global Smoother,
/// Min et al. 2014).
void smooth_filled_depth(DepthMap& map, const ColorImage& photograph, double one_pixel);

}  // namespace lumi
