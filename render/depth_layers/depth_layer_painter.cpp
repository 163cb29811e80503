#include "render/depth_layers/depth_layer_painter.h"

#include <epoxy/gl.h>

#include "calib/capture/inverse_depth_warp.h"
#include "render/depth_layers/depth_kind_ranges.h"
#include "render/gl/to_glm.h"
#include "render/shaders/shader_sources.h"

namespace lumi {
namespace {

/// OpenGL before 4.1 and OpenGL ES have one of the two each.
void set_depth_range(double near_depth, double far_depth) {
    if (epoxy_is_desktop_gl())
        glDepthRange(near_depth, far_depth);
    else
        glDepthRangef(static_cast<float>(near_depth), static_cast<float>(far_depth));
}

}  // namespace

DepthLayerPainter::DepthLayerPainter(const std::vector<LumigraphView>& views,
                                     const std::vector<std::shared_ptr<const DepthMesh>>& meshes)
    : views_(views),
      program_("depth_layer", {shader_source("depth_layer")}),
      seen_program_("depth_layer", {shader_source("depth_layer")}, {"MARKS_BEHIND_TEARS"}) {
    static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
    meshes_.reserve(meshes.size());
    for (const auto& mesh : meshes) {
        meshes_.emplace_back(std::vector<VertexAttribute>{{0, 3}});
        meshes_.back().upload(mesh->vertices.data(),
                              mesh->vertices.size() * sizeof(Eigen::Vector3f), mesh->indices);
    }
}

void DepthLayerPainter::begin_layer(const TextureArray& layers, int layer) {
    constexpr GLfloat kNothing = 1.0F;
    framebuffer_.attach_depth_layer(layers, layer);
    glDisable(GL_SCISSOR_TEST);
    glClearBufferfv(GL_DEPTH, 0, &kNothing);
    glEnable(GL_SCISSOR_TEST);
}

void DepthLayerPainter::draw(const Eye& eye, const std::vector<DepthLayerDraw>& draws,
                             double max_inverse_depth, float agreeing_depth,
                             const TextureArray& layers) {
    const Camera& camera = eye.camera;
    if (stretched_.width_px() != camera.width_px || stretched_.height_px() != camera.height_px)
        stretched_ = TextureArray(TexelFormat::kDepth, TexelFilter::kNearest, camera.width_px,
                                  camera.height_px, 1);
    glViewport(0, 0, camera.width_px, camera.height_px);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    seen_program_.use();
    seen_program_.set("stretched", 0);
    seen_program_.set("agreeing_depth", agreeing_depth);
    for (int layer = 0; layer < layers.layers(); ++layer) {
        const auto draw_if = [&](const auto& is_drawn) {
            for (const DepthLayerDraw& draw : draws)
                if (draw.layer == layer && is_drawn(static_cast<DepthKind>(draw.kind)))
                    draw_triangles(
                        draw, eye, max_inverse_depth,
                        draw.kind == static_cast<int>(DepthKind::kSeen) ? seen_program_ : program_);
        };
        begin_layer(stretched_, 0);
        draw_if([](DepthKind kind) { return kind == DepthKind::kStretched; });
        begin_layer(layers, layer);
        stretched_.bind(0);
        draw_if([](DepthKind) { return true; });
    }
    set_depth_range(0.0, 1.0);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

void DepthLayerPainter::draw_triangles(const DepthLayerDraw& draw, const Eye& eye,
                                       double max_inverse_depth, const Program& program) const {
    glScissor(draw.strip_begin_px, 0, draw.strip_end_px - draw.strip_begin_px,
              eye.camera.height_px);
    const double range_begin = kDepthKindStep * draw.kind;
    set_depth_range(range_begin, range_begin + kDepthKindWidth);
    program.use();
    program.set("clip_from_view_pixel",
                to_glm(clip_from_view_pixel(eye, draw.view_index, max_inverse_depth)));
    meshes_[static_cast<std::size_t>(draw.view_index)].draw(draw.first_index, draw.index_count);
}

/// Of a view's pixel as (x, y, 1, inverse depth).
Eigen::Matrix4d DepthLayerPainter::clip_from_view_pixel(const Eye& eye, int view_index,
                                                        double max_inverse_depth) const {
    const LumigraphView& view = views_[static_cast<std::size_t>(view_index)];
    const InverseDepthWarp eye_from_view = warp_from(view).to(eye);
    // (x, y, 1, q) of the view to (X, Y, W, q) of the eye.
    Eigen::Matrix4d transfer = Eigen::Matrix4d::Identity();
    transfer.topLeftCorner<3, 3>() = eye_from_view.infinite_homography;
    transfer.topRightCorner<3, 1>() = eye_from_view.epipole;
    return clip_from_pixel(eye.camera.width_px, eye.camera.height_px, max_inverse_depth) * transfer;
}

}  // namespace lumi
