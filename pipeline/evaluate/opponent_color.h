#pragma once

#include <array>

#include "calib/capture/image.h"

namespace lumi {

using Color3 = std::array<float, 3>;

/// sRGB (IEC 61966-2-1) to linear RGB, 0 to 1.
[[nodiscard]] Color3 linear_from_srgb(const Rgb8& color);

/// Linear RGB to the linear opponent space YyCxCz (luminance, red-green, blue-yellow; white point
/// D65) and back: the space in which contrast sensitivity is measured.
[[nodiscard]] Color3 opponent_from_linear(const Color3& linear);
[[nodiscard]] Color3 linear_from_opponent(const Color3& opponent);

/// Each channel within 0 to 1.
[[nodiscard]] Color3 clamped(const Color3& linear);

/// Linear RGB to CIE L*a*b* (D65) with Hunt's adjustment: chroma counts less in the dark.
[[nodiscard]] Color3 hunt_adjusted_lab(const Color3& linear);

}  // namespace lumi
