#pragma once

#include <vector>

#include "meshing/exposure/shared_tiles.h"
#include "meshing/surface/pictured_view.h"

namespace lumi {

/// The falloff of light towards the corners (light_left.h) that all photographs have in common, by
/// how the brightness of surfaces changes as they come to lie elsewhere in the picture: robust
/// least squares (Cauchy) over the tiles of all pairs, each pair with an exposure of its own
/// (compare Goldman and Chen, Vignette and Exposure Calibration and Compensation, 2005).
///
/// None, 0, unless photographs tell it: at least six pairs share enough to be asked, as four views
/// have that all share a scene, since of one pair it cannot be told from light that falls
/// differently on what it shows; fitted to one colour of the chequerboard it must be better
/// at the other than no falloff, by more than one standard error (Breiman et al. 1984), more than
/// twice as large as the fits to the two colours are off from their mean, and take at least 8 % of
/// its light from a corner, as surfaces that shine seem to add or take up to so much, but no more
/// than 7/8. Pictures that are
/// brighter in their corners have none: no lens makes them so.
[[nodiscard]] double light_falloff(const std::vector<PicturedView>& views,
                                   const std::vector<SharedTiles>& pairs);

}  // namespace lumi
