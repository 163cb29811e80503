#include "render/renderer/lumigraph_renderer.h"

#include <epoxy/gl.h>

#include <map>

#include "calib/work/error.h"
#include "render/modes/adaptive.h"
#include "render/modes/light_field.h"
#include "render/modes/paper2001.h"
#include "render/modes/per_pixel.h"
#include "render/reference/depth_of_others.h"
#include "render/rivals/heigl.h"

namespace lumi {
namespace {

Eye fitted(const Eye& eye, const Viewport& viewport) {
    if (!is_pinhole(eye.camera))
        throw Error(ErrorKind::kUsage, "E-EYE-LENS",
                    "frames are drawn for a pinhole camera, the eye's lens has distortion",
                    "leave the distortion out of the eye's camera");
    if (eye.camera.width_px == viewport.width_px && eye.camera.height_px == viewport.height_px)
        return eye;
    return {resized(eye.camera, viewport.width_px, viewport.height_px), eye.cam_from_world};
}

void clear(const Viewport& viewport) {
    glViewport(viewport.x_px, viewport.y_px, viewport.width_px, viewport.height_px);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_SCISSOR_TEST);
    glScissor(viewport.x_px, viewport.y_px, viewport.width_px, viewport.height_px);
    glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace

struct LumigraphRenderer::Implementation {
    explicit Implementation(const Lumigraph& lumigraph) : uploaded(lumigraph) {}

    /// Made when it is first asked for.
    DrawingMode& mode(RenderMode wanted) {
        std::unique_ptr<DrawingMode>& mode = modes[wanted];
        if (!mode) mode = made(wanted);
        return *mode;
    }

    [[nodiscard]] std::unique_ptr<DrawingMode> made(RenderMode mode) const {
        switch (mode) {
            case RenderMode::kLightField:
                return std::make_unique<LightField>(uploaded);
            case RenderMode::kPerPixel:
                return std::make_unique<PerPixel>(uploaded);
            case RenderMode::kAdaptive:
                return std::make_unique<Adaptive>(uploaded);
            case RenderMode::kPaper2001:
                return std::make_unique<Paper2001>(uploaded);
            case RenderMode::kHeigl:
                return std::make_unique<Heigl>(uploaded);
        }
        return nullptr;
    }

    UploadedLumigraph uploaded;
    std::map<RenderMode, std::unique_ptr<DrawingMode>> modes;
};

LumigraphRenderer::LumigraphRenderer(const Lumigraph& lumigraph) {
    if (lacks_depth(lumigraph))
        implementation_ = std::make_unique<Implementation>(with_depth_of_others(lumigraph));
    else
        implementation_ = std::make_unique<Implementation>(lumigraph);
}
LumigraphRenderer::~LumigraphRenderer() = default;
LumigraphRenderer::LumigraphRenderer(LumigraphRenderer&& other) noexcept = default;
LumigraphRenderer& LumigraphRenderer::operator=(LumigraphRenderer&& other) noexcept = default;

DrawStatistics LumigraphRenderer::draw(const Eye& eye, const RenderOptions& wanted,
                                       const Viewport& viewport) {
    const RenderOptions options =
        possible_options(wanted, implementation_->uploaded.layout.has_depth());
    const Eye fitted_eye = fitted(eye, viewport);
    implementation_->uploaded.prepare(fitted_eye, options);
    clear(viewport);
    const DrawStatistics statistics =
        implementation_->mode(options.mode).draw(fitted_eye, options, viewport);
    glUseProgram(0);
    glActiveTexture(GL_TEXTURE0);
    return statistics;
}

void LumigraphRenderer::forget_frame() {
    for (const auto& [name, mode] : implementation_->modes)
        if (mode) mode->forget_frame();
}

void LumigraphRenderer::choose(const DrawingChoices& drawing) {
    if (drawing == implementation_->uploaded.layout.drawing) return;
    implementation_->uploaded.choose(drawing);
    implementation_->modes.clear();  // Each was made for other choices.
}

std::size_t LumigraphRenderer::texture_bytes() const {
    return implementation_->uploaded.photographs.bytes() +
           implementation_->uploaded.depth_maps.bytes();
}

}  // namespace lumi
