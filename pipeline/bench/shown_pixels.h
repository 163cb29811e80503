#pragma once

#include <vector>

#include "calib/capture/image.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Of a frame whose z is known (0: nothing there), 255 where a view shows what is there, and 0
/// where none does, so that nobody can draw it but by chance. The views' depth is exact: a view
/// shows a point whose inverse depth in it lies between those of the samples around, which are of
/// one surface. Where nothing is, it is shown by whom the same direction shows nothing, too.
[[nodiscard]] GrayImage shown_pixels(const FloatImage& z, const Eye& eye,
                                     const std::vector<LumigraphView>& views);

}  // namespace lumi
