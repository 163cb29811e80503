#pragma once

#include <cstddef>
#include <vector>

#include "meshing/surface/nearest_cameras.h"

namespace lumi {

/// Each of an eye's blends has a strip of its picture, from the left to the right, as wide as its
/// share: where the strips end, in columns. Strips move with the eye, so that it is a line that
/// passes when one camera is exchanged for another. Whole blocks of pixels (pixel_blocks.h) lie in
/// one strip, the same in a picture that was widened to whole blocks.
[[nodiscard]] std::vector<int> blend_strip_ends(const std::vector<EyeBlend>& blends, int width_px);

/// The number of the strip in which a pixel lies.
[[nodiscard]] std::size_t strip_at(const std::vector<int>& strip_ends, double pixel_x);

}  // namespace lumi
