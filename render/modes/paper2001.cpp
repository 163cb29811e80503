#include "render/modes/paper2001.h"

#include <epoxy/gl.h>

#include "render/painters/blend_painter.h"
#include "render/shaders/shader_sources.h"
#include "render/subdivision/paper_subdivision.h"
#include "render/transfer/scene_plane.h"

namespace lumi {

Paper2001::Paper2001(const UploadedLumigraph& uploaded)
    : uploaded_(uploaded),
      program_("projective_pass",
               {shader_source("blend_vertex"), shader_source("projective_pass")}),
      triangles_(blend_vertex_attributes()) {}

DrawStatistics Paper2001::draw(const Eye& eye, const RenderOptions& options, const Viewport&) {
    const Lumigraph& layout = uploaded_.layout;
    const DepthSearch search(layout, uploaded_.searched_views, eye);
    const BlendTriangles triangles = paper_subdivision(
        face_polygons(layout.mesh, eye), search, scene_plane_inverse_depth(layout, eye),
        inverse_depth_range(layout), options.correct_occlusion, paper_subdivision_options(options));
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
