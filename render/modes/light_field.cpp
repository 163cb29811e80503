#include "render/modes/light_field.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <utility>

#include "render/faces/off_cameras.h"
#include "render/shaders/shader_sources.h"
#include "render/subdivision/affine_pieces.h"
#include "render/surroundings/empty_cells.h"
#include "render/transfer/pixel_transfer.h"
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
        const PixelTransfer transfer =
            pixel_transfer(view.camera, view.cam_from_world, eye.camera, eye.cam_from_world);
        views.push_back(
            {transfer.at_infinity + transfer.per_inverse_depth * plane_inverse_depth.transpose(),
             static_cast<double>(view.camera.width_px),
             static_cast<double>(view.camera.height_px)});
    }
    return views;
}

/// What is not a photograph's, and need not vary on a piece as that does.
bool tells_of_rays(DebugPicture picture) {
    return picture != DebugPicture::kNone && picture != DebugPicture::kGrid;
}

/// Less than this of all weights is too little to be averaged over a piece (affine_pieces.h).
constexpr double kHardlyAny = 0.01;

/// Whether the view shows the plane, or what is infinitely far beyond it, at all of these corners.
bool shows_all(const std::vector<Eigen::Vector2d>& corners, std::size_t view,
               const Eigen::Vector3d& plane, const std::vector<PlaneView>& on_plane,
               const std::vector<PlaneView>& beyond) {
    return std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector2d& corner) {
        const bool is_near = plane.dot(corner.homogeneous()) > 0;
        const PlaneView& as_seen = (is_near ? on_plane : beyond)[view];
        const Eigen::Vector3d pixel = as_seen.view_from_eye * corner.homogeneous();
        return pixel.z() > 0 && pixel.x() >= 0 && pixel.y() >= 0 &&
               pixel.x() <= as_seen.width_px * pixel.z() &&
               pixel.y() <= as_seen.height_px * pixel.z();
    });
}

/// Positive where a view has nearly all of a polygon's weight, as beside its camera.
Eigen::Vector3d nearly_all_of(const FacePolygon& polygon, int view) {
    Eigen::Vector3d line = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        line +=
            (polygon.view_indices[k] == view ? kHardlyAny : kHardlyAny - 1) * polygon.side_lines[k];
    return line;
}

/// Cuts off where a photograph ends that has nearly all weight: beyond it pixels have others.
void cut_off_beside_cameras(FacePolygon& polygon, const Eigen::Vector3d& plane,
                            const std::vector<PlaneView>& on_plane,
                            const std::vector<PlaneView>& beyond,
                            std::vector<FacePolygon>& cut_off) {
    const std::array<int, 3>& views = polygon.view_indices;
    if (views[0] == views[1] && views[1] == views[2]) return;
    for (const int view : views) {
        const Eigen::Vector3d line = nearly_all_of(polygon, view);
        std::vector<Eigen::Vector2d> part = clipped(polygon.corners_px, line);
        if (part.size() < 3 ||
            shows_all(part, static_cast<std::size_t>(view), plane, on_plane, beyond))
            continue;
        polygon.corners_px = clipped(polygon.corners_px, -line);
        cut_off.push_back(polygon);
        cut_off.back().corners_px = std::move(part);
    }
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
    return options.focal_depth > 0 ? focal_plane_inverse_depth(options.focal_depth)
                                   : scene_plane_inverse_depth(uploaded_.layout, eye);
}

DrawStatistics LightField::draw_polygons(std::vector<FacePolygon> polygons, const Eye& eye,
                                         const RenderOptions& options) {
    const Lumigraph& layout = uploaded_.layout;
    const Eigen::Vector3d plane = plane_of(eye, options);
    const std::vector<PlaneView> on_plane = plane_views(layout, eye, plane);
    const std::vector<PlaneView> beyond = plane_views(layout, eye, Eigen::Vector3d::Zero());
    if (are_surroundings_drawn(options)) {
        PictureCells cells(eye.camera);
        mark_beyond_mesh(layout.mesh, eye, cells);
        mark_where_none_may_be_shown(polygons, layout.views, eye, plane, cells,
                                     unsure_border_px(uploaded_.lod_of(eye, options)));
        surroundings_.draw(cells, eye);
    }
    affine_.clear();
    exact_.clear();
    for (FacePolygon& polygon : polygons) {
        if (tells_of_rays(options.debug_picture)) {
            exact_.push_back(std::move(polygon));
            continue;
        }
        cut_off_beside_cameras(polygon, plane, on_plane, beyond, exact_);
        // A wide picture also shows what is no longer on the plane, but infinitely far.
        const std::vector<Eigen::Vector2d> corners = polygon.corners_px;
        polygon.corners_px = clipped(corners, plane);
        cut_into_affine_pieces(polygon, on_plane, plane, {}, affine_, exact_);
        polygon.corners_px = clipped(corners, -plane);
        cut_into_affine_pieces(polygon, beyond, plane, {}, affine_, exact_);
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
