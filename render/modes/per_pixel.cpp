#include "render/modes/per_pixel.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <string>

#include "render/gl/to_glm.h"
#include "render/modes/depth_eye.h"
#include "render/modes/depth_view_choice.h"
#include "render/modes/empty_cells.h"
#include "render/modes/pixel_transfer.h"
#include "render/modes/scene_plane.h"
#include "render/shaders/shader_sources.h"

namespace lumi {
namespace {

constexpr std::size_t kRowsPerView = 4;

}  // namespace

PerPixel::PerPixel(const UploadedLumigraph& uploaded)
    : uploaded_(uploaded),
      surroundings_(uploaded),
      layer_count_(
          std::min(uploaded.layout.depth_views, static_cast<int>(uploaded.layout.views.size()))),
      depth_(uploaded, layer_count_),
      faces_(uploaded),
      program_("per_pixel", {shader_source("face"), shader_source("per_pixel")},
               {"LAYERS " + std::to_string(layer_count_)}),
      fading_("per_pixel", {shader_source("face"), shader_source("per_pixel")},
              {"LAYERS " + std::to_string(layer_count_), "FADES"}) {}

DrawStatistics PerPixel::draw(const Eye& eye, const RenderOptions& options,
                              const Viewport& viewport) {
    const AskedDepth asked{depth_view_sets(uploaded_.layout, eye, layer_count_),
                           depth_eye(uploaded_.layout, eye, options)};
    {
        const FramebufferBindingKeeper keeper;
        depth_.draw(asked.depth_eye.eye, asked.sets);
    }
    glViewport(viewport.x_px, viewport.y_px, viewport.width_px, viewport.height_px);
    const Eigen::Vector3d plane = scene_plane_inverse_depth(uploaded_.layout, eye);
    const CameraMesh& mesh = uploaded_.layout.mesh;
    const std::vector<FacePolygon> polygons = face_polygons(mesh, eye);
    if (are_surroundings_drawn(options)) {
        PictureCells cells(eye.camera);
        mark_where_none_may_be_shown(polygons, uploaded_.layout.views, eye, plane, cells);
        surroundings_.draw(cells, eye);
    }
    const Program& program =
        use(options.fade_beyond_capture ? fading_ : program_, eye, options, viewport, asked);
    if (options.fade_beyond_capture) set_fade(program, false);
    std::size_t triangles = faces_.draw(polygons, eye, plane);
    if (options.debug_picture == DebugPicture::kGrid) grid_.draw(polygons, eye);
    if (mesh.shells.empty()) return {triangles};
    set_fade(use(fading_, eye, options, viewport, asked), true);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const CameraMesh& shell : mesh.shells)
        triangles += faces_.draw(face_polygons(shell, eye, kNoOverlap_px), eye, plane);
    glDisable(GL_BLEND);
    return {triangles};
}

const Program& PerPixel::use(PictureProgram& picture, const Eye& eye, const RenderOptions& options,
                             const Viewport& viewport, const AskedDepth& asked) {
    const Program& program = picture.use(uploaded_, eye, options);
    uploaded_.depth_maps.bind(1);
    depth_.texture().bind(2);
    program.set("depth_maps", 1);
    program.set("depth_layers", 2);
    program.set("viewport_origin", glm::vec2(viewport.x_px, viewport.y_px));
    program.set("max_inverse_depth", static_cast<float>(depth_.max_inverse_depth()));
    program.set("near_inverse_depth",
                static_cast<float>(inverse_depth_range(uploaded_.layout).y()));
    program.set(
        "check_per_px",
        static_cast<float>(options.correct_occlusion ? 1 / options.occlusion_tolerance_px : 0.0));
    set_layers(eye, options, asked, program);
    return program;
}

void PerPixel::set_layers(const Eye& eye, const RenderOptions& options, const AskedDepth& asked,
                          const Program& program) const {
    const double agreeing =
        agreeing_inverse_depth(uploaded_.geometries, asked.sets, options.occlusion_tolerance_px);
    program.set("agreeing_depth", static_cast<float>(depth_.buffer_difference(agreeing)));
    const auto& [depth_eye, texels_per_pixel] = asked.depth_eye;
    program.set("texels_per_pixel", static_cast<float>(texels_per_pixel));
    // Rows are counted from the top of either picture, window coordinates from the bottom.
    program.set("texels_below", static_cast<float>(depth_eye.camera.height_px -
                                                   texels_per_pixel * eye.camera.height_px));
    glm::vec4 ends(static_cast<float>(depth_eye.camera.width_px));
    int set = 0;
    for (const int end : strip_ends(asked.sets, depth_eye.camera.width_px))
        ends[set++] = static_cast<float>(end);
    program.set("strip_ends", ends);
    set_layer_views(eye, asked.sets, program);
}

/// Four vectors for each layer of each set, as shaders/per_pixel.glsl expects them.
void PerPixel::set_layer_views(const Eye& eye, const std::vector<DepthViewSet>& sets,
                               const Program& program) const {
    std::vector<glm::vec4> rows;
    for (const std::vector<int>& in_layers : depth_layer_views(sets, layer_count_)) {
        for (const int view_index : in_layers) append_view(eye, view_index, rows);
        rows.resize(rows.size() +
                    kRowsPerView * static_cast<std::size_t>(kMaxDepthViews - layer_count_));
    }
    program.set("layer_views", rows);
}

void PerPixel::append_view(const Eye& eye, int view_index, std::vector<glm::vec4>& rows) const {
    if (view_index == kNoView) return rows.resize(rows.size() + kRowsPerView);
    const LumigraphView& view = uploaded_.layout.views[static_cast<std::size_t>(view_index)];
    const PixelTransfer view_from_eye =
        pixel_transfer(view.camera, view.cam_from_world, eye.camera, eye.cam_from_world);
    const Eigen::Matrix3d view_from_window =
        view_from_eye.at_infinity * pixel_from_window(eye.camera.height_px);
    for (Eigen::Index row = 0; row < 3; ++row)
        rows.push_back(to_glm(Eigen::Vector4d(view_from_window(row, 0), view_from_window(row, 1),
                                              view_from_window(row, 2),
                                              view_from_eye.per_inverse_depth[row])));
    rows.emplace_back(view_index, view.camera.width_px, view.camera.height_px, 1.0F);
}

}  // namespace lumi
