#pragma once

#include "calib/capture/image.h"

namespace lumi {

/// Values that are drawn in the brightest colour.
constexpr float kFlipFullScale = 0.5F;
constexpr float kGhostFullScale = 32.0F;  ///< Standard deviation in 8-bit luma.

/// Values as colours, from dark blue (0) to bright yellow (`full_scale` and more).
[[nodiscard]] ColorImage heat_map(const FloatImage& values, float full_scale);

[[nodiscard]] FloatImage square_root(const FloatImage& values);

}  // namespace lumi
