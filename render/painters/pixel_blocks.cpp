#include "render/painters/pixel_blocks.h"

#include <epoxy/gl.h>

#include "render/shaders/shader_sources.h"

namespace lumi {
namespace {

constexpr int kPixelsOfBlock = PixelBlocks::kSide_px * PixelBlocks::kSide_px;

int blocks_along(int pixels) {
    return (pixels + PixelBlocks::kSide_px - 1) / PixelBlocks::kSide_px;
}

}  // namespace

PixelBlocks::PixelBlocks()
    : lay_out_("lay_out", {shader_source("screen"), shader_source("lay_out")}) {}

Viewport PixelBlocks::begin(int width_px, int height_px) {
    const int columns = blocks_along(width_px);
    const int rows = blocks_along(height_px);
    if (rasters_.width_px() != columns || rasters_.height_px() != rows)
        rasters_ =
            TextureArray(TexelFormat::kColor, TexelFilter::kNearest, columns, rows, kPixelsOfBlock);
    framebuffer_.attach_color_layers(rasters_);
    glViewport(0, 0, columns, rows);
    glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    return {0, 0, columns, rows};
}

void PixelBlocks::lay_out(const Viewport& viewport) const {
    glViewport(viewport.x_px, viewport.y_px, viewport.width_px, viewport.height_px);
    lay_out_.use();
    rasters_.bind(0);
    lay_out_.set("blocks", 0);
    lay_out_.set("from_origin_px",
                 glm::vec2(-viewport.x_px, rows_below(viewport.height_px) - viewport.y_px));
    screen_.draw();
}

Eye PixelBlocks::covering(Eye eye) {
    eye.camera.width_px = kSide_px * blocks_along(eye.camera.width_px);
    eye.camera.height_px = kSide_px * blocks_along(eye.camera.height_px);
    return eye;
}

}  // namespace lumi
