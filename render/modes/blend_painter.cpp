#include "render/modes/blend_painter.h"

#include <epoxy/gl.h>

#include "render/shaders/shader_sources.h"

namespace lumi {

const std::vector<VertexAttribute>& blend_vertex_attributes() {
    static_assert(sizeof(BlendVertex) == 23 * sizeof(float));
    static const std::vector<VertexAttribute> attributes{{0, 3}, {1, 4}, {2, 2}, {3, 3},
                                                         {4, 3}, {5, 4}, {6, 3}, {7, 1}};
    return attributes;
}

BlendPainter::BlendPainter(const UploadedLumigraph& uploaded, float least_confidence)
    : uploaded_(uploaded),
      least_confidence_(least_confidence),
      program_("blend", {shader_source("blend")}),
      see_through_("blend", {shader_source("blend")}, {"FADES"}),
      triangles_(blend_vertex_attributes()) {}

void BlendPainter::draw(const BlendTriangles& triangles, const Eye& eye,
                        const RenderOptions& options, Opacity opacity) {
    if (triangles.indices.empty()) return;
    triangles_.upload(triangles.vertices.data(), triangles.vertices.size() * sizeof(BlendVertex),
                      triangles.indices);
    const bool is_opaque = opacity == Opacity::kOpaque;
    const Program& program = (is_opaque ? program_ : see_through_).use(uploaded_, eye, options);
    program.set("layer_size",
                glm::vec2(uploaded_.photographs.width_px(), uploaded_.photographs.height_px()));
    program.set("least_confidence", least_confidence_);
    if (!is_opaque) glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    triangles_.draw(0, triangles.indices.size());
    glDisable(GL_BLEND);
    if (options.debug_picture == DebugPicture::kGrid) grid_.draw(triangles, eye);
}

}  // namespace lumi
