#include "render/painters/supersampled_target.h"

#include <epoxy/gl.h>

#include "render/shaders/shader_sources.h"

namespace lumi {

SupersampledTarget::SupersampledTarget(int width_px, int height_px)
    : width_px_(width_px),
      height_px_(height_px),
      samples_(TexelFormat::kColor, TexelFilter::kNearest, 2 * width_px, 2 * height_px, 1),
      program_("halve", {shader_source("screen"), shader_source("halve")}) {
    framebuffer_.attach_color_layer(samples_, 0);
}

void SupersampledTarget::halve() const {
    glViewport(0, 0, width_px_, height_px_);
    program_.use();
    samples_.bind(0);
    program_.set("picture", 0);
    screen_.draw();
    glUseProgram(0);
}

}  // namespace lumi
