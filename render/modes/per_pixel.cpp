#include "render/modes/per_pixel.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "render/depth_layers/depth_eye.h"
#include "render/depth_layers/depth_layer_views.h"
#include "render/depth_layers/layer_rows.h"
#include "render/faces/asked_views.h"
#include "render/holes/hole_cells.h"
#include "render/holes/hole_triangles.h"
#include "render/shaders/shader_sources.h"
#include "render/surroundings/empty_cells.h"
#include "render/transfer/scene_plane.h"
#include "render/view_choice/depth_view_choice.h"

namespace lumi {
namespace {

PictureProgram program_of(std::vector<std::string> definitions) {
    return {"per_pixel",
            {shader_source("drawn_pixels"), shader_source("face"), shader_source("agreed_depth"),
             shader_source("point_in_views"), shader_source("lone_surfaces"),
             shader_source("per_pixel")},
            std::move(definitions)};
}

// Strips of depth end where pixels of several texels do (strip_ends.h).
static_assert(kSmoothTexelsPerPixel == kDepthBlockSide_px);

/// The first of the fragments whose centre lies in this column of texels or beyond it.
int first_fragment(int column, double texels_per_fragment) {
    return static_cast<int>(std::ceil(column / texels_per_fragment - 0.5));
}

/// Silhouettes are not smooth where depth would not fit into a texture for it.
RenderOptions drawable(RenderOptions options, const Camera& camera, int max_texture_size_px) {
    const int side_px = std::max(camera.width_px, camera.height_px);
    if (kSmoothTexelsPerPixel * side_px > max_texture_size_px) options.smooth_silhouettes = false;
    return options;
}

}  // namespace

PerPixel::PerPixel(const UploadedLumigraph& uploaded, DepthLayers::DrawnBy depth_drawn_by)
    : uploaded_(uploaded),
      surroundings_(uploaded),
      layer_count_(std::min(uploaded.layout.drawing.depth_views,
                            static_cast<int>(uploaded.layout.views.size()))),
      depth_(uploaded, layer_count_, depth_drawn_by),
      faces_(uploaded),
      blend_(uploaded, kLeastConfidence),
      in_pixels_(programs({})),
      smooth_(programs({"SMOOTH"})),
      in_blocks_(programs({"BLOCKS"})),
      fading_(programs({"FADES"})) {}

std::vector<std::string> PerPixel::layer_definitions() const {
    std::vector<std::string> definitions{"LAYERS " + std::to_string(layer_count_)};
    if (depth_.is_packed()) definitions.emplace_back("PACKED_LAYERS");
    return definitions;
}

PerPixel::Programs PerPixel::programs(const std::vector<std::string>& definitions) const {
    const auto of_faces = [&](int unasked_views) {
        std::vector<std::string> all = layer_definitions();
        all.insert(all.end(), definitions.begin(), definitions.end());
        all.push_back("UNASKED_VIEWS " + std::to_string(unasked_views));
        if (uploaded_.layout.drawing.checks_guesses) all.emplace_back("CHECKS_GUESSES");
        return program_of(std::move(all));
    };
    return {of_faces(0), of_faces(1), of_faces(2), of_faces(3)};
}

DrawStatistics PerPixel::draw(const Eye& eye, const RenderOptions& wanted,
                              const Viewport& viewport) {
    const RenderOptions options =
        drawable(wanted, eye.camera, uploaded_.capabilities.max_texture_size_px);
    AskedDepth asked{depth_view_sets(uploaded_.layout, eye, layer_count_),
                     depth_eye(uploaded_.layout, eye, options),
                     PictureCells(eye.camera, kHoleCell_px)};
    {
        const FramebufferBindingKeeper keeper;
        depth_.draw(asked.depth_eye.eye, asked.sets);
        if (uploaded_.layout.drawing.fills_holes && !options.fade_beyond_capture)
            asked.holes = found_holes(asked.depth_eye, eye.camera);
    }
    glViewport(viewport.x_px, viewport.y_px, viewport.width_px, viewport.height_px);
    std::size_t triangles = draw_base(eye, options, viewport, asked);
    triangles += draw_shells(eye, options, viewport, asked);
    return {triangles};
}

PictureCells PerPixel::open_cells(const std::vector<FacePolygon>& polygons, const Eye& eye,
                                  const RenderOptions& options) const {
    PictureCells cells(eye.camera);
    if (!are_surroundings_drawn(options)) return cells;
    if (uploaded_.layout.drawing.checks_guesses) {
        cells.mark_all();
        return cells;
    }
    mark_beyond_mesh(uploaded_.layout.mesh, eye, cells);
    mark_where_none_may_be_shown(polygons, uploaded_.layout.views, eye,
                                 scene_plane_inverse_depth(uploaded_.layout, eye), cells);
    return cells;
}

std::size_t PerPixel::draw_base(const Eye& eye, const RenderOptions& options,
                                const Viewport& viewport, const AskedDepth& asked) {
    const bool in_blocks = is_drawn_in_blocks(uploaded_.layout, eye, options);
    const Eye drawn = in_blocks ? PixelBlocks::covering(eye) : eye;
    const std::vector<FacePolygon> polygons = face_polygons(uploaded_.layout.mesh, drawn);
    const PictureCells cells = open_cells(polygons, drawn, options);
    std::size_t triangles = 0;
    if (in_blocks) {
        {
            const FramebufferBindingKeeper keeper;
            const Viewport rasters = blocks_.begin(viewport.width_px, viewport.height_px);
            surroundings_.draw_in_blocks(cells, drawn);
            const Fragments blocks{rasters, PixelBlocks::rows_below(viewport.height_px),
                                   PixelBlocks::kSide_px};
            triangles = draw_strips(polygons, eye, options, blocks, asked, Fade::kNone);
        }
        blocks_.lay_out(viewport);
    } else {
        surroundings_.draw(cells, eye);
        const Fade fade = options.fade_beyond_capture ? Fade::kBeyondCapture : Fade::kNone;
        triangles = draw_strips(polygons, eye, options, {viewport}, asked, fade);
    }
    triangles += fill_holes(eye, options, asked);
    if (options.debug_picture == DebugPicture::kGrid) grid_.draw(polygons, eye);
    return triangles;
}

PictureCells PerPixel::found_holes(const DepthEye& depth_eye, const Camera& camera) {
    if (!holes_) holes_.emplace(layer_definitions());
    return holes_->find(depth_.texture(), depth_.agreeing_depth(), depth_eye, camera);
}

std::size_t PerPixel::fill_holes(const Eye& eye, const RenderOptions& options,
                                 const AskedDepth& asked) {
    const BlendTriangles triangles = hole_triangles(uploaded_.layout, uploaded_.searched_views, eye,
                                                    options, asked.holes, subdivider_);
    blend_.draw(triangles, eye, options, Behind::kGuesses);
    return triangles.count();
}

std::size_t PerPixel::draw_shells(const Eye& eye, const RenderOptions& options,
                                  const Viewport& viewport, const AskedDepth& asked) {
    if (uploaded_.layout.mesh.shells.empty()) return 0;
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    std::size_t triangles = 0;
    for (const CameraMesh& shell : uploaded_.layout.mesh.shells) {
        const std::vector<FacePolygon> polygons = face_polygons(shell, eye, kNoOverlap_px);
        triangles += draw_strips(polygons, eye, options, {viewport}, asked, Fade::kShell);
        if (options.debug_picture == DebugPicture::kGrid) grid_.draw(polygons, eye);
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
                static_cast<float>(scene_inverse_depths(uploaded_.layout).near));
    program.set("check_per_px",
                static_cast<float>(options.correct_occlusion
                                       ? 1 / uploaded_.layout.drawing.occlusion_tolerance_px
                                       : 0.0));
    program.set("agreeing_depth", depth_.agreeing_depth());
    const auto& [depth_eye, texels_per_pixel] = asked.depth_eye;
    program.set("texels_per_pixel", static_cast<float>(texels_per_pixel));
    // Rows are counted from the top of either picture, window coordinates from the bottom.
    const int height_px =
        fragments.viewport.height_px * fragments.side_px - fragments.rows_below_px;
    program.set("texels_below",
                static_cast<float>(depth_eye.camera.height_px - texels_per_pixel * height_px));
    return program;
}

std::size_t PerPixel::draw_strips(const std::vector<FacePolygon>& polygons, const Eye& eye,
                                  const RenderOptions& options, const Fragments& fragments,
                                  const AskedDepth& asked, Fade fade) {
    const Eigen::Vector3d plane = scene_plane_inverse_depth(uploaded_.layout, eye);
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
        faces_.upload(asked_first(polygons, views[set]), eye, plane);
        // All strips draw the same ones, which count once.
        triangles = draw_faces(eye, options, fragments, asked, fade, views[set]);
        begin = end;
    }
    glDisable(GL_SCISSOR_TEST);
    return triangles;
}

std::size_t PerPixel::draw_faces(const Eye& eye, const RenderOptions& options,
                                 const Fragments& fragments, const AskedDepth& asked, Fade fade,
                                 const std::vector<int>& layer_views) {
    Programs& programs = fade != Fade::kNone           ? fading_
                         : fragments.side_px > 1       ? in_blocks_
                         : asked.depth_eye.is_smooth() ? smooth_
                                                       : in_pixels_;
    const Eye drawn = fragments.side_px > 1 ? PixelBlocks::covering(eye) : eye;
    std::size_t triangles = 0;
    for (std::size_t unasked = 0; unasked < programs.size(); ++unasked) {
        const auto is_drawn = [&](const std::array<int, 3>& views) {
            return unasked_views(views, layer_views) == unasked;
        };
        if (!faces_.has_any(is_drawn)) continue;
        const Program& program = use(programs[unasked], drawn, options, fragments, asked);
        if (fade != Fade::kNone) set_fade(program, fade == Fade::kShell);
        program.set("layer_views", pixel_rows(uploaded_.layout, eye, layer_views));
        if (!depth_.is_packed())
            program.set("layer_samples",
                        sample_rows(uploaded_.layout, asked.depth_eye.eye, layer_views));
        triangles += faces_.draw_if(is_drawn);
    }
    return triangles;
}

}  // namespace lumi
