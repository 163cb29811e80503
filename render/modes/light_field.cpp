#include "render/modes/light_field.h"

#include <epoxy/gl.h>

#include <utility>

#include "calib/capture/inverse_depth_warp.h"
#include "render/faces/off_cameras.h"
#include "render/shaders/shader_sources.h"
#include "render/subdivision/affine_pieces.h"
#include "render/surroundings/empty_cells.h"
#include "render/transfer/focal_plane.h"
#include "render/transfer/polygon_clipping.h"
#include "render/transfer/scene_plane.h"
#include "render/uploaded/photograph_lod.h"

namespace lumi {
namespace {

/// The views as the scene plane shows them.
std::vector<PlaneView> plane_views(const Lumigraph& lumigraph, const Eye& eye,
                                   const Eigen::Vector3d& plane_inverse_depth) {
    std::vector<PlaneView> views;
    for (const LumigraphView& view : lumigraph.views) {
        views.push_back({warp_from(eye).to(view).homography_of(plane_inverse_depth),
                         static_cast<double>(view.camera.width_px),
                         static_cast<double>(view.camera.height_px)});
    }
    return views;
}

/// What is not a photograph's, and need not vary on a piece as that does.
bool tells_of_rays(DebugPicture picture) {
    return picture != DebugPicture::kNone && picture != DebugPicture::kGrid;
}

}  // namespace

LightField::LightField(const UploadedLumigraph& uploaded)
    : uploaded_(uploaded),
      surroundings_(uploaded),
      blend_(uploaded),
      faces_(uploaded),
      program_("light_field", {shader_source("drawn_pixels"), shader_source("face"),
                               shader_source("light_field")}),
      fading_("light_field",
              {shader_source("drawn_pixels"), shader_source("face"), shader_source("light_field")},
              {"FADES"}) {}

DrawStatistics LightField::draw(const Eye& eye, const RenderOptions& options, const Viewport&) {
    const CameraMesh& mesh = uploaded_.layout.mesh;
    DrawStatistics statistics;
    if (options.fade_beyond_capture) {
        statistics.triangles = draw_fading(mesh, eye, options, false);
    } else {
        statistics = draw_polygons(face_polygons(mesh, off_cameras(mesh, eye)), eye, options);
    }
    if (mesh.shells.empty()) return statistics;
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const CameraMesh& shell : mesh.shells)
        statistics.triangles += draw_fading(shell, eye, options, true);
    glDisable(GL_BLEND);
    return statistics;
}

/// Pixel by pixel: how much of what lies behind shows through is far from affine.
std::size_t LightField::draw_fading(const CameraMesh& mesh, const Eye& eye,
                                    const RenderOptions& options, bool is_shell) {
    const Eigen::Vector3d plane = plane_of(eye, options);
    set_fade(fading_.use(uploaded_, eye, options), is_shell);
    const std::vector<FacePolygon> polygons =
        is_shell ? face_polygons(mesh, eye, kNoOverlap_px)
                 : face_polygons(mesh, off_cameras(mesh, eye), kOverlap_px);
    faces_.upload(polygons, eye, plane);
    const std::size_t triangles = faces_.draw();
    if (options.debug_picture == DebugPicture::kGrid) grid_.draw(polygons, eye);
    return triangles;
}

Eigen::Vector3d LightField::plane_of(const Eye& eye, const RenderOptions& options) const {
    return options.focal_plane.depth > 0 ? focal_plane_inverse_depth(options.focal_plane, eye)
                                         : scene_plane_inverse_depth(uploaded_.layout, eye);
}

DrawStatistics LightField::draw_polygons(std::vector<FacePolygon> polygons, const Eye& eye,
                                         const RenderOptions& options) {
    const Lumigraph& layout = uploaded_.layout;
    const Eigen::Vector3d plane = plane_of(eye, options);
    const std::vector<PlaneView> on_plane = plane_views(layout, eye, plane);
    const std::vector<PlaneView> beyond = plane_views(layout, eye, Eigen::Vector3d::Zero());
    const double border_px = unsure_border_px(uploaded_.lod_of(eye, options));
    if (are_surroundings_drawn(options)) {
        PictureCells cells(eye.camera);
        // As the eye that its faces are drawn for sees it.
        mark_beyond_mesh(layout.mesh, off_cameras(layout.mesh, eye), cells);
        mark_where_none_may_be_shown(polygons, layout.views, eye, plane, cells, border_px);
        surroundings_.draw(cells, eye);
    }
    const AffinePieceOptions pieces{.unsure_border_px = border_px};
    affine_.clear();
    exact_.clear();
    for (FacePolygon& polygon : polygons) {
        if (tells_of_rays(options.debug_picture)) {
            exact_.push_back(std::move(polygon));
            continue;
        }
        // A wide picture also shows what is no longer on the plane, but infinitely far.
        const std::vector<Eigen::Vector2d> corners = polygon.corners_px;
        polygon.corners_px = clipped(corners, plane);
        cut_into_affine_pieces(polygon, on_plane, plane, pieces, affine_, exact_);
        polygon.corners_px = clipped(corners, -plane);
        cut_into_affine_pieces(polygon, beyond, plane, pieces, affine_, exact_);
    }
    blend_.draw(affine_, eye, options);
    DrawStatistics statistics{affine_.count()};
    if (exact_.empty()) return statistics;
    program_.use(uploaded_, eye, options);
    faces_.upload(exact_, eye, plane);
    statistics.triangles += faces_.draw();
    if (options.debug_picture == DebugPicture::kGrid) grid_.draw(exact_, eye);
    return statistics;
}

}  // namespace lumi
