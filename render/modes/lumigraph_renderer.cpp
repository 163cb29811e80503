#include "render/modes/lumigraph_renderer.h"

#include <epoxy/gl.h>

#include <optional>

#include "calib/work/error.h"
#include "render/modes/light_field.h"
#include "render/modes/per_pixel.h"

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
    explicit Implementation(const Lumigraph& lumigraph)
        : uploaded(lumigraph), light_field(uploaded) {
        if (uploaded.has_depth()) per_pixel.emplace(uploaded, lumigraph);
    }

    DrawingMode& mode(RenderMode wanted) {
        if (wanted == RenderMode::kPerPixel && per_pixel) return *per_pixel;
        return light_field;
    }

    UploadedLumigraph uploaded;
    LightField light_field;
    std::optional<PerPixel> per_pixel;
};

LumigraphRenderer::LumigraphRenderer(const Lumigraph& lumigraph)
    : implementation_(std::make_unique<Implementation>(lumigraph)) {}
LumigraphRenderer::~LumigraphRenderer() = default;
LumigraphRenderer::LumigraphRenderer(LumigraphRenderer&& other) noexcept = default;
LumigraphRenderer& LumigraphRenderer::operator=(LumigraphRenderer&& other) noexcept = default;

void LumigraphRenderer::draw(const Eye& eye, const RenderOptions& options,
                             const Viewport& viewport) {
    const Eye fitted_eye = fitted(eye, viewport);
    clear(viewport);
    implementation_->mode(options.mode).draw(fitted_eye, options, viewport);
    glUseProgram(0);
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace lumi
