#pragma once

#include <cstdint>

#include "calib/capture/image.h"

namespace lumi {

/// Depth as one view sees it, with how much to trust it.
///
/// `inverse_depth` is 1/z along the optical axis in 1/world units; it may be smaller than the
/// view's photograph and covers the same field of view (pixel centres at (x + 0.5, y + 0.5) of its
/// own raster). Zero with confidence > 0 means infinitely far; with confidence 0 the value is a
/// fill for drawing only, and NaN is never stored.
struct DepthMap {
    FloatImage inverse_depth;
    GrayImage confidence;  ///< 0: filled, not seen. 255: agreed on by several views.
};

/// Confidence of what was filled, but is known to stand before a background: it hides that, and no
/// more is known of it.
inline constexpr std::uint8_t kFilledBeforeBackground = 1;

/// Whether depth of this confidence tells where a surface is. What was filled does not, whether it
/// stands before a background or not.
[[nodiscard]] constexpr bool was_seen(std::uint8_t confidence) {
    return confidence > kFilledBeforeBackground;
}

}  // namespace lumi
