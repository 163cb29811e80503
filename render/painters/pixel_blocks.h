#pragma once

#include "render/frame/viewport.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/gl/screen.h"
#include "render/gl/texture.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// A frame that is drawn in blocks of two by two pixels: a fragment stands for a block, works out
/// once what its pixels share, and draws each of them into a raster of its own (coarse pixel
/// shading: Vaidyanathan et al. 2014). The rasters are then laid out as the frame. Blocks are
/// counted from the frame's top left; the last ones may reach beyond it.
class PixelBlocks {
 public:
    static constexpr int kSide_px = kDepthBlockSide_px;

    PixelBlocks();

    /// Binds rasters for a frame of this size, black and not covered, and makes the viewport
    /// theirs: in blocks.
    Viewport begin(int width_px, int height_px);
    /// Draws the blocks into the bound framebuffer, over all that was there: the viewport has the
    /// size of the frame that was begun.
    void lay_out(const Viewport& viewport) const;

    /// Of a frame, rows that blocks reach below it.
    [[nodiscard]] static int rows_below(int height_px) { return height_px % kSide_px; }
    /// The eye of all blocks: its picture's size is even.
    [[nodiscard]] static Eye covering(Eye eye);

 private:
    TextureArray rasters_;
    Framebuffer framebuffer_;
    Program lay_out_;
    Screen screen_;
};

}  // namespace lumi
