#pragma once

#include <array>

namespace lumi {

/// The transfer curve of sRGB (IEC 61966-2-1): light, 0 to 1, of an encoded value, 0 to 1.
[[nodiscard]] double light_of_srgb(double encoded);
/// The same of every 8-bit value.
[[nodiscard]] const std::array<float, 256>& light_of_srgb_bytes();
/// The inverse of light_of_srgb. Values beyond 0 to 1 are taken to the nearest of these.
[[nodiscard]] double srgb_of_light(double light);

}  // namespace lumi
