#include "render/renderer/offscreen_renderer.h"

#include "render/gl/capabilities.h"
#include "render/renderer/frame_target.h"
#include "render/renderer/lumigraph_renderer.h"

namespace lumi {

struct OffscreenRenderer::Implementation {
    Implementation(const Lumigraph& lumigraph, GlApi api) : context(api), renderer(lumigraph) {}
    ~Implementation() { context.make_current(); }

    HeadlessContext context;
    LumigraphRenderer renderer;
    FrameTarget target;
};

OffscreenRenderer::OffscreenRenderer(const Lumigraph& lumigraph, GlApi api)
    : implementation_(std::make_unique<Implementation>(lumigraph, api)) {}
OffscreenRenderer::~OffscreenRenderer() = default;

void OffscreenRenderer::choose(const DrawingChoices& drawing) {
    implementation_->context.make_current();
    implementation_->renderer.choose(drawing);
}

Frame OffscreenRenderer::draw(const Eye& eye, const RenderOptions& options) {
    Implementation& gl = *implementation_;
    gl.context.make_current();
    const DrawStatistics statistics = gl.target.draw(gl.renderer, eye, options);
    Frame frame = gl.target.read();
    frame.statistics = statistics;
    return frame;
}

std::string OffscreenRenderer::gl_description() const {
    implementation_->context.make_current();
    return query_capabilities().description;
}

}  // namespace lumi
