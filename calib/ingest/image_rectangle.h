#pragma once

#include <compare>

namespace lumi {

/// Pixels from `left` and `top` on.
struct ImageRectangle {
    int left = 0;
    int top = 0;
    int width_px = 0;
    int height_px = 0;
    friend auto operator<=>(const ImageRectangle&, const ImageRectangle&) = default;
};

}  // namespace lumi
