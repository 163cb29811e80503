#pragma once

#include <vector>

#include "calib/work/progress.h"
#include "meshing/surface/pictured_view.h"
#include "meshing/transients/known_view.h"

namespace lumi {

/// Transients: what was there for one photograph alone, or two. People who walk through a scene,
/// cars that pass, a hand before the lens.
///
/// Where three other views and more agree upon a surface and its colour, and a photograph shows
/// another, something hides the surface from it, or it shines. What stands still hides or mirrors
/// something in the photographs beside this one, too, displaced by its parallax, or stands where
/// these cannot see it (counterparts.h). A patch of pixels that differ is a transient if hardly any
/// of them may stand still, each at an inverse depth of its own.

/// Smaller ones than this share of the picture are not told from what depth has wrong.
inline constexpr double kLeastTransientShare = 0.002;

/// Of each view 255 on its transients, else 0; empty images where it shows none.
[[nodiscard]] std::vector<GrayImage> transients_of(const std::vector<KnownView>& views, int threads,
                                                   Progress& progress);

}  // namespace lumi
