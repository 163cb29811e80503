#pragma once

namespace lumi {

/// A rectangle of the bound framebuffer in window coordinates: the origin is at its bottom left.
struct Viewport {
    int x_px = 0;
    int y_px = 0;
    int width_px = 0;
    int height_px = 0;
};

}  // namespace lumi
