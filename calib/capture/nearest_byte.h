#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lumi {

/// The 8-bit step that is nearest to a channel's value: 0 below the range, 255 above it.
[[nodiscard]] inline std::uint8_t nearest_byte(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

}  // namespace lumi
