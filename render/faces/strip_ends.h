#pragma once

#include <vector>

namespace lumi {

/// A picture is divided into strips from the left to the right, as wide as their shares, which sum
/// to 1: where each ends, in columns of a picture of this width. All but the last end where blocks
/// of kDepthBlockSide_px do, so that none of what is drawn at once lies in two: a block of pixels,
/// or the texels of a pixel (kSmoothTexelsPerPixel).
[[nodiscard]] std::vector<int> strip_ends(const std::vector<double>& shares, int width_px);

}  // namespace lumi
