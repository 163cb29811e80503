#pragma once

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The mip level that photographs are looked up at for an eye, 0 the finest, by how many pixels of
/// a photograph fall on one of the eye's, at the distance of the scene's centre. One level a frame:
/// all that one is drawn from is about as large. Where photographs are not, by their size or lens,
/// those count that see the scene from the eye's direction. Where the eye has several samples
/// across a pixel, a photograph is looked up for the whole pixel.
///
/// Mostly it is a whole number, and one level is looked up instead of two: the finest up to 2
/// texels a pixel, the next from 3 to 4, the third from 6 to 8. In smaller frames that costs
/// held-out photographs 0.2 dB at most beside two levels, which take longer to look up, wherever
/// more than 1.5 texels of the finest fall on a pixel.
[[nodiscard]] double photograph_lod(const Lumigraph& lumigraph, const Eye& eye,
                                    double samples_across_pixel = 1.0);

/// How far inside of its border, in its pixels, a photograph surely counts at a mip level: at all
/// but the finest the texels along the border do not (TextureArray::make_mip_levels).
[[nodiscard]] double unsure_border_px(double lod);

}  // namespace lumi
