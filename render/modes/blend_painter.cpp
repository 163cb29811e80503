#include "render/modes/blend_painter.h"

#include "render/shaders/shader_sources.h"

namespace lumi {

const std::vector<VertexAttribute>& blend_vertex_attributes() {
    static_assert(sizeof(BlendVertex) == 21 * sizeof(float));
    static const std::vector<VertexAttribute> attributes{{0, 3}, {1, 4}, {2, 2}, {3, 3},
                                                         {4, 2}, {5, 4}, {6, 3}};
    return attributes;
}

BlendPainter::BlendPainter(const UploadedLumigraph& uploaded)
    : uploaded_(uploaded),
      program_("blend", {shader_source("blend")}),
      triangles_(blend_vertex_attributes()) {}

void BlendPainter::draw(const BlendTriangles& triangles, const Eye& eye,
                        const RenderOptions& options) {
    if (triangles.indices.empty()) return;
    triangles_.upload(triangles.vertices.data(), triangles.vertices.size() * sizeof(BlendVertex),
                      triangles.indices);
    const Program& program = program_.use(uploaded_, eye, options);
    program.set("layer_size",
                glm::vec2(uploaded_.photographs.width_px(), uploaded_.photographs.height_px()));
    triangles_.draw(0, triangles.indices.size());
}

}  // namespace lumi
