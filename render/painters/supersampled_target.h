#pragma once

#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/gl/screen.h"
#include "render/gl/texture.h"

namespace lumi {

/// A raster of four samples a pixel. The context that made it must be current.
class SupersampledTarget {
 public:
    /// Sizes are those of the picture that it becomes.
    SupersampledTarget(int width_px, int height_px);

    /// Draws go to the samples: twice the picture's width and height.
    void bind() const { framebuffer_.bind(); }
    /// Each pixel of the bound framebuffer becomes the mean of its four samples.
    void halve() const;

 private:
    int width_px_;
    int height_px_;
    TextureArray samples_;
    Framebuffer framebuffer_;
    Program program_;
    Screen screen_;
};

}  // namespace lumi
