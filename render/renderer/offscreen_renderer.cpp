#include "render/renderer/offscreen_renderer.h"

#include "render/gl/capabilities.h"
#include "render/renderer/frame_target.h"
#include "render/renderer/lumigraph_renderer.h"

namespace lumi {

struct OffscreenRenderer::Implementation {
    /// What is made of GL objects.
    struct Drawing {
        explicit Drawing(const Lumigraph& lumigraph) : renderer(lumigraph) {}

        LumigraphRenderer renderer;
        FrameTarget target;
    };

    Implementation(const Lumigraph& lumigraph, GlApi api)
        : context(api), drawing(std::make_unique<Drawing>(lumigraph)) {}
    /// Where the context cannot be made current, its objects are left to it: another's would be
    /// deleted.
    ~Implementation() {
        if (!context.try_make_current()) (void)drawing.release();
    }

    HeadlessContext context;
    std::unique_ptr<Drawing> drawing;
};

OffscreenRenderer::OffscreenRenderer(const Lumigraph& lumigraph, GlApi api)
    : implementation_(std::make_unique<Implementation>(lumigraph, api)) {}
OffscreenRenderer::~OffscreenRenderer() = default;

void OffscreenRenderer::choose(const DrawingChoices& drawing) {
    implementation_->context.make_current();
    implementation_->drawing->renderer.choose(drawing);
}

Frame OffscreenRenderer::draw(const Eye& eye, const RenderOptions& options) {
    implementation_->context.make_current();
    auto& [renderer, target] = *implementation_->drawing;
    const DrawStatistics statistics = target.draw(renderer, eye, options);
    Frame frame = target.read();
    frame.statistics = statistics;
    return frame;
}

void OffscreenRenderer::forget_frame() {
    implementation_->context.make_current();
    implementation_->drawing->renderer.forget_frame();
}

std::string OffscreenRenderer::gl_description() const {
    implementation_->context.make_current();
    return query_capabilities().description;
}

}  // namespace lumi
