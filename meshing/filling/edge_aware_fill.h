#pragma once

#include "calib/capture/image.h"
#include "meshing/agreement/surrounding_depth.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Gives every pixel of confidence 0 an inverse depth; known pixels and all confidences stay.
///
/// Where `surrounding` knows a pixel, that is taken. Any other unknown pixel looks for known ones
/// in eight directions, beyond the picture's border too, and continues the planes that it finds
/// there. What lies clearly before the farthest of them does not count: a hole beside an object is
/// mostly what the object hides, so it continues the background (Hirschmueller 2008, section 2.5).
/// The rest is weighted by nearness, and then smoothed along the photograph's edges (Fast Global
/// Smoother, Min et al. 2014). Where nothing is known in any direction, `fallback` is taken.
///
/// `one_pixel` is the inverse depth that makes one pixel of disparity; 0 when there is no parallax.
void edge_aware_fill(DepthMap& map, const ColorImage& photograph, const FloatImage& fallback,
                     double one_pixel, SurroundingDepth surrounding = {});

/// The first half of it: the planes continued. Returns how far from what is known those pixels lie
/// that have known ones in at most half of the directions; 0 for all others.
///
/// Where other views know something that the photograph does not show (depth_of_others.h: `hidden`,
/// empty or of the map's size), only what lies clearly before that is continued, if anything does.
FloatImage continue_known_depth(DepthMap& map, const FloatImage& fallback, double one_pixel,
                                SurroundingDepth surrounding = {}, const DepthMap& hidden = {});

/// The second half: what was filled is smoothed along the photograph's edges.
void smooth_filled_depth(DepthMap& map, const ColorImage& photograph, double one_pixel);

}  // namespace lumi
