#pragma once

#include <cstdint>

#include "calib/capture/image.h"

namespace lumi {

/// Depth as one view sees it, with how much to trust it.
///
/// `inverse_depth` is 1/z along the optical axis in 1/world units; it may be smaller than the
/// view's photograph and covers the same field of view (pixel centres at (x + 0.5, y + 0.5) of its
/// own raster). Zero where a pixel was seen means infinitely far; elsewhere the value is a fill for
/// drawing only. NaN is never stored.
struct DepthMap {
    FloatImage inverse_depth;
    GrayImage confidence;  ///< By the table below; in between: told by scene points.
};

/// Confidence of what was not seen: the value is a fill, and nothing is known there.
inline constexpr std::uint8_t kUnseen = 0;
/// Confidence of what was filled, but is known to stand before a background: it hides that, and no
/// more is known of it.
inline constexpr std::uint8_t kFilledBeforeBackground = 1;
/// Highest confidence of what scene points alone tell: the less, the farther off they are.
inline constexpr std::uint8_t kMostByPoints = 127;
/// Confidence of what one other view confirms, or that is as good: what others agree upon where the
/// view itself knows nothing.
inline constexpr std::uint8_t kConfirmedByOne = 128;
/// Confidence of what two other views confirm, or more.
inline constexpr std::uint8_t kConfirmedBySeveral = 255;
/// Confidence of what needs nobody to confirm it or was not yet put to others: measured depth,
/// geometry that is drawn, and what a model is sure of.
inline constexpr std::uint8_t kKnown = kConfirmedBySeveral;

/// The confidence of what so many others agree with.
[[nodiscard]] constexpr std::uint8_t confidence_of_support(int agreeing) {
    return agreeing == 0 ? kUnseen : agreeing == 1 ? kConfirmedByOne : kConfirmedBySeveral;
}

/// Whether depth of this confidence tells where a surface is. What was filled does not, whether it
/// stands before a background or not.
[[nodiscard]] constexpr bool was_seen(std::uint8_t confidence) {
    return confidence > kFilledBeforeBackground;
}

}  // namespace lumi
