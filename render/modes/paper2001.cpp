#include "render/modes/paper2001.h"

#include <epoxy/gl.h>

#include "render/painters/blend_painter.h"
#include "render/shaders/shader_sources.h"
#include "render/subdivision/paper_subdivision.h"

namespace lumi {

Paper2001::Paper2001(const UploadedLumigraph& uploaded)
    : uploaded_(uploaded),
      program_("projective_pass",
               {shader_source("blend_vertex"), shader_source("projective_pass")}),
      triangles_(blend_vertex_attributes()) {}

DrawStatistics Paper2001::draw(const Eye& eye, const RenderOptions& options, const Viewport&) {
    return draw_polygons(face_polygons(uploaded_.layout.mesh, eye), eye, options);
}

DrawStatistics Paper2001::draw_polygons(const std::vector<FacePolygon>& polygons, const Eye& eye,
                                        const RenderOptions& options) {
    const BlendTriangles triangles =
        paper_triangles(polygons, uploaded_.layout, uploaded_.searched_views, eye, options);
    draw_passes(triangles, eye, options);
    if (options.debug_picture == DebugPicture::kGrid) grid_.draw(triangles, eye);
    return {triangles.count()};
}

void Paper2001::draw_passes(const BlendTriangles& triangles, const Eye& eye,
                            const RenderOptions& options) {
    triangles_.upload(triangles.vertices.data(), triangles.vertices.size() * sizeof(BlendVertex),
                      triangles.indices);
    const Program& program = program_.use(uploaded_, eye, options);
    program.set("layer_size",
                glm::vec2(uploaded_.photographs.width_px(), uploaded_.photographs.height_px()));
    glEnable(GL_BLEND);
    // Weights add up to 1 and no further: patches overlap by a little (face_polygons.h), and pixels
    // there would be twice as bright.
    glBlendFuncSeparate(GL_SRC_ALPHA_SATURATE, GL_ONE, GL_ONE, GL_ONE);
    for (const glm::vec3& chosen : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)}) {
        program.set("chosen", chosen);
        triangles_.draw(0, triangles.indices.size());
    }
    glDisable(GL_BLEND);
}

}  // namespace lumi
