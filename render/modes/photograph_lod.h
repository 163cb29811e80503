#pragma once

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The mip level that photographs are looked up at for an eye, 0 the finest: the logarithm to base
/// 2 of how many pixels of a photograph fall on one of the eye's, at the distance of the scene's
/// centre and for the median view. One level a frame: all photographs of a scene are about as large
/// from far away. Where the eye has several samples
/// across a pixel, a photograph is looked up for the whole pixel. Up to 1.5 pixels the finest is
/// right, and beyond that 1.5 are left to a pixel.
[[nodiscard]] double photograph_lod(const Lumigraph& lumigraph, const Eye& eye,
                                    double samples_across_pixel = 1.0);

}  // namespace lumi
