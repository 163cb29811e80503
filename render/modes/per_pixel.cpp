#include "render/modes/per_pixel.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

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

PictureProgram program_of(int layers, std::vector<std::string> definitions = {}) {
    definitions.push_back("LAYERS " + std::to_string(layers));
    return {"per_pixel",
            {shader_source("face"), shader_source("agreed_depth"), shader_source("per_pixel")},
            std::move(definitions)};
}

/// The first of the fragments whose centre lies in this column of texels or beyond it.
int first_fragment(int column, double texels_per_fragment) {
    return static_cast<int>(std::ceil(column / texels_per_fragment - 0.5));
}

}  // namespace

PerPixel::PerPixel(const UploadedLumigraph& uploaded)
    : uploaded_(uploaded),
      surroundings_(uploaded),
      layer_count_(
          std::min(uploaded.layout.depth_views, static_cast<int>(uploaded.layout.views.size()))),
      depth_(uploaded, layer_count_),
      faces_(uploaded),
      program_(program_of(layer_count_)),
      in_blocks_(program_of(layer_count_, {"BLOCKS"})),
      fading_(program_of(layer_count_, {"FADES"})) {}

DrawStatistics PerPixel::draw(const Eye& eye, const RenderOptions& options,
                              const Viewport& viewport) {
    const AskedDepth asked{depth_view_sets(uploaded_.layout, eye, layer_count_),
                           depth_eye(uploaded_.layout, eye, options)};
    {
        const FramebufferBindingKeeper keeper;
        depth_.draw(asked.depth_eye.eye, asked.sets);
    }
    glViewport(viewport.x_px, viewport.y_px, viewport.width_px, viewport.height_px);
    const bool in_blocks = is_drawn_in_blocks(uploaded_.layout, options);
    const std::vector<FacePolygon> polygons =
        face_polygons(uploaded_.layout.mesh, in_blocks ? PixelBlocks::covering(eye) : eye);
    if (are_surroundings_drawn(options)) {
        PictureCells cells(eye.camera);
        mark_beyond_mesh(uploaded_.layout.mesh, eye, cells);
        mark_where_none_may_be_shown(polygons, uploaded_.layout.views, eye,
                                     scene_plane_inverse_depth(uploaded_.layout, eye), cells);
        surroundings_.draw(cells, eye);
    }
    std::size_t triangles = draw_base(polygons, eye, options, viewport, asked);
    if (options.debug_picture == DebugPicture::kGrid) grid_.draw(polygons, eye);
    triangles += draw_shells(eye, options, viewport, asked);
    return {triangles};
}

std::size_t PerPixel::draw_base(const std::vector<FacePolygon>& polygons, const Eye& eye,
                                const RenderOptions& options, const Viewport& viewport,
                                const AskedDepth& asked) {
    faces_.upload(polygons, eye, scene_plane_inverse_depth(uploaded_.layout, eye));
    if (!is_drawn_in_blocks(uploaded_.layout, options)) {
        const Fragments pixels{viewport};
        const bool fades = options.fade_beyond_capture;
        const Program& program = use(fades ? fading_ : program_, eye, options, pixels, asked);
        if (fades) set_fade(program, false);
        return draw_strips(eye, pixels, asked, program);
    }
    std::size_t triangles = 0;
    {
        const FramebufferBindingKeeper keeper;
        const Viewport rasters = blocks_.begin(viewport.width_px, viewport.height_px);
        const Fragments blocks{rasters, PixelBlocks::rows_below(viewport.height_px),
                               PixelBlocks::kSide_px};
        const Program& program =
            use(in_blocks_, PixelBlocks::covering(eye), options, blocks, asked);
        triangles = draw_strips(eye, blocks, asked, program);
    }
    blocks_.lay_out(viewport);
    return triangles;
}

std::size_t PerPixel::draw_shells(const Eye& eye, const RenderOptions& options,
                                  const Viewport& viewport, const AskedDepth& asked) {
    if (uploaded_.layout.mesh.shells.empty()) return 0;
    const Fragments pixels{viewport};
    const Program& program = use(fading_, eye, options, pixels, asked);
    set_fade(program, true);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    const Eigen::Vector3d plane = scene_plane_inverse_depth(uploaded_.layout, eye);
    std::size_t triangles = 0;
    for (const CameraMesh& shell : uploaded_.layout.mesh.shells) {
        faces_.upload(face_polygons(shell, eye, kNoOverlap_px), eye, plane);
        triangles += draw_strips(eye, pixels, asked, program);
    }
    glDisable(GL_BLEND);
    return triangles;
}

const Program& PerPixel::use(PictureProgram& picture, const Eye& eye, const RenderOptions& options,
                             const Fragments& fragments, const AskedDepth& asked) {
    const Program& program = picture.use(uploaded_, eye, options);
    uploaded_.depth_maps.bind(1);
    depth_.texture().bind(2);
    program.set("depth_maps", 1);
    program.set("depth_layers", 2);
    program.set("viewport_origin", glm::vec2(fragments.viewport.x_px,
                                             fragments.viewport.y_px + fragments.rows_below_px));
    program.set("max_inverse_depth", static_cast<float>(depth_.max_inverse_depth()));
    program.set("near_inverse_depth",
                static_cast<float>(inverse_depth_range(uploaded_.layout).y()));
    program.set(
        "check_per_px",
        static_cast<float>(options.correct_occlusion ? 1 / options.occlusion_tolerance_px : 0.0));
    const double agreeing =
        agreeing_inverse_depth(uploaded_.layout, uploaded_.geometries, asked.sets,
                               centre_in_world(eye.cam_from_world), options.occlusion_tolerance_px);
    program.set("agreeing_depth", static_cast<float>(depth_.buffer_difference(agreeing)));
    const auto& [depth_eye, texels_per_pixel] = asked.depth_eye;
    program.set("texels_per_pixel", static_cast<float>(texels_per_pixel));
    // Rows are counted from the top of either picture, window coordinates from the bottom.
    const int height_px =
        fragments.viewport.height_px * fragments.side_px - fragments.rows_below_px;
    program.set("texels_below",
                static_cast<float>(depth_eye.camera.height_px - texels_per_pixel * height_px));
    return program;
}

std::size_t PerPixel::draw_strips(const Eye& eye, const Fragments& fragments,
                                  const AskedDepth& asked, const Program& program) const {
    const DepthLayerViews views = depth_layer_views(asked.sets, layer_count_);
    const std::vector<int> ends = strip_ends(asked.sets, asked.depth_eye.eye.camera.width_px);
    const double texels_per_fragment = fragments.side_px * asked.depth_eye.texels_per_pixel;
    const Viewport& viewport = fragments.viewport;
    std::size_t triangles = 0;
    int begin = 0;
    glEnable(GL_SCISSOR_TEST);
    for (std::size_t set = 0; set < ends.size(); ++set) {
        const bool is_last = set + 1 == ends.size();
        const int end =
            is_last ? viewport.width_px
                    : std::min(viewport.width_px, first_fragment(ends[set], texels_per_fragment));
        if (end <= begin) continue;
        glScissor(viewport.x_px + begin, viewport.y_px, end - begin, viewport.height_px);
        set_layer_views(eye, views[set], program);
        triangles = faces_.draw();
        begin = end;
    }
    glDisable(GL_SCISSOR_TEST);
    return triangles;
}

/// Four vectors for each layer, as shaders/agreed_depth.glsl expects them.
void PerPixel::set_layer_views(const Eye& eye, const std::vector<int>& view_indices,
                               const Program& program) const {
    std::vector<glm::vec4> rows;
    for (const int view_index : view_indices) append_view(eye, view_index, rows);
    rows.resize(kRowsPerView * kMaxDepthViews);
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
    rows.emplace_back(view_index, 0.0F, 0.0F, 0.0F);
}

}  // namespace lumi
