#pragma once

#include <memory>
#include <string>

#include "render/frame/frame.h"
#include "render/gl/headless_context.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Draws frames without a window (HeadlessContext): OpenGL 3.3 core or OpenGL ES 3.0.
///
/// For one thread, in which several may live: each call makes its own context current. Throws Error
/// (E-GL-CONTEXT, E-GL-LIMIT) that says what was asked and what was found.
class OffscreenRenderer {
 public:
    explicit OffscreenRenderer(const Lumigraph& lumigraph, GlApi api = GlApi::kAny);
    ~OffscreenRenderer();
    OffscreenRenderer(const OffscreenRenderer&) = delete;
    OffscreenRenderer& operator=(const OffscreenRenderer&) = delete;

    /// LumigraphRenderer::choose. Throws Error (E-GL-CONTEXT).
    void choose(const DrawingChoices& drawing);
    [[nodiscard]] Frame draw(const Eye& eye, const RenderOptions& options);
    /// LumigraphRenderer::forget_frame.
    void forget_frame();
    /// GL_RENDERER and GL_VERSION, for reports.
    [[nodiscard]] std::string gl_description() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace lumi
