#pragma once

#include "render/depth_search/depth_search.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {

/// Keeps photographs to their own surfaces where there are guesses.
///
/// Guesses of neighbouring corners lie on different surfaces wherever another view's was taken. A
/// photograph that counts at one corner of such a triangle, and at another not at all, would be
/// swept from the one surface to the other, over whatever it shows between. It is looked up there
/// instead where its ray meets the mean inverse depth of the corners at which it counts: it fades
/// out on the surface that it shows. What was seen is not changed, as neighbours agree on it.
///
/// Corners that are looked up elsewhere are made anew, for their triangle alone.
void keep_own_surfaces(const DepthSearch& search, BlendTriangles& triangles);

}  // namespace lumi
