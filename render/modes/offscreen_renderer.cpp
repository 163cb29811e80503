#include "render/modes/offscreen_renderer.h"

#include "render/gl/capabilities.h"
#include "render/gl/framebuffer.h"
#include "render/gl/to_glm.h"
#include "render/modes/lumigraph_renderer.h"

namespace lumi {
namespace {

Frame frame_from_rgba(const std::vector<unsigned char>& rgba, int width, int height) {
    Frame frame{ColorImage(width, height), GrayImage(width, height)};
    for (int y = 0; y < height; ++y) {
        const unsigned char* texel =
            rgba.data() + 4 * static_cast<std::size_t>(framebuffer_row(y, height)) *
                              static_cast<std::size_t>(width);
        for (int x = 0; x < width; ++x, texel += 4) {
            frame.color(x, y) = {texel[0], texel[1], texel[2]};
            frame.coverage(x, y) = texel[3];
        }
    }
    return frame;
}

}  // namespace

struct OffscreenRenderer::Implementation {
    Implementation(const Lumigraph& lumigraph, GlApi api) : context(api), renderer(lumigraph) {}
    ~Implementation() { context.make_current(); }

    HeadlessContext context;
    LumigraphRenderer renderer;
    Framebuffer framebuffer;
    int width_px = 0;
    int height_px = 0;
};

OffscreenRenderer::OffscreenRenderer(const Lumigraph& lumigraph, GlApi api)
    : implementation_(std::make_unique<Implementation>(lumigraph, api)) {}
OffscreenRenderer::~OffscreenRenderer() = default;

Frame OffscreenRenderer::draw(const Eye& eye, const RenderOptions& options) {
    Implementation& gl = *implementation_;
    gl.context.make_current();
    const int width = eye.camera.width_px;
    const int height = eye.camera.height_px;
    if (width != gl.width_px || height != gl.height_px) {
        gl.framebuffer.attach_color(width, height);
        gl.width_px = width;
        gl.height_px = height;
    }
    gl.framebuffer.bind();
    gl.renderer.draw(eye, options, {0, 0, width, height});
    return frame_from_rgba(gl.framebuffer.read_rgba_bottom_up(width, height), width, height);
}

std::string OffscreenRenderer::gl_description() const {
    implementation_->context.make_current();
    return query_capabilities().description;
}

}  // namespace lumi
