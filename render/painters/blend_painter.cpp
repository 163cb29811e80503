#include "render/painters/blend_painter.h"

#include <epoxy/gl.h>

#include <string>
#include <utility>

#include "render/shaders/shader_sources.h"
#include "render/uploaded/photograph_lod.h"

namespace lumi {

const std::vector<VertexAttribute>& blend_vertex_attributes() {
    static_assert(sizeof(BlendVertex) == 26 * sizeof(float));
    static const std::vector<VertexAttribute> attributes{{0, 3}, {1, 4}, {2, 2}, {3, 3},
                                                         {4, 3}, {5, 4}, {6, 3}, {7, 4}};
    return attributes;
}

namespace {

PictureProgram blend_program(int lookups, std::vector<std::string> definitions) {
    definitions.push_back("LOOKUPS " + std::to_string(lookups));
    return {
        "blend", {shader_source("blend_vertex"), shader_source("blend")}, std::move(definitions)};
}

std::array<PictureProgram, 3> blend_programs(const std::vector<std::string>& definitions) {
    return {blend_program(1, definitions), blend_program(2, definitions),
            blend_program(3, definitions)};
}

}  // namespace

BlendPainter::BlendPainter(const UploadedLumigraph& uploaded, float least_confidence)
    : uploaded_(uploaded),
      least_confidence_(least_confidence),
      programs_(blend_programs({})),
      discarding_(blend_programs({"DISCARDS"})),
      filling_(blend_programs({"FILLS"})),
      fading_(blend_programs({"FADES"})),
      known_alone_(blend_programs({"KNOWN_ALONE"})),
      triangles_(blend_vertex_attributes()) {}

void BlendPainter::draw(const BlendTriangles& triangles, const Eye& eye,
                        const RenderOptions& options, Behind behind) {
    if (triangles.indices.empty()) return;
    const TrianglesByLookups sorted = sorted_by_lookups(
        triangles, uploaded_.layout.views, unsure_border_px(uploaded_.lod_of(eye, options)));
    const std::vector<BlendVertex>& vertices = sorted.triangles.vertices;
    triangles_.upload(vertices.data(), vertices.size() * sizeof(BlendVertex),
                      sorted.triangles.indices);
    const bool fades = behind == Behind::kBlack || behind == Behind::kPicture;
    if (fades) glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    if (behind == Behind::kGuesses) glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_DST_ALPHA);
    if (fades || behind == Behind::kGuesses) glEnable(GL_BLEND);
    std::size_t first = 0;
    for (const LookupRun& run : sorted.runs) {
        const Program& program = program_for(run, behind).use(uploaded_, eye, options);
        program.set("layer_size",
                    glm::vec2(uploaded_.photographs.width_px(), uploaded_.photographs.height_px()));
        program.set("least_confidence", least_confidence_);
        if (fades) program.set("is_laid_over", behind == Behind::kPicture ? 1.0F : 0.0F);
        triangles_.draw(first, run.index_count);
        first += run.index_count;
    }
    glDisable(GL_BLEND);
    if (options.debug_picture == DebugPicture::kGrid) grid_.draw(triangles, eye);
}

PictureProgram& BlendPainter::program_for(const LookupRun& run, Behind behind) {
    if (behind == Behind::kBlack || behind == Behind::kPicture) return fading_[run.lookups - 1];
    if (behind == Behind::kGuesses) return known_alone_[run.lookups - 1];
    if (!run.may_show_none) return programs_[run.lookups - 1];
    return (behind == Behind::kSurroundings ? filling_ : discarding_)[run.lookups - 1];
}

}  // namespace lumi
