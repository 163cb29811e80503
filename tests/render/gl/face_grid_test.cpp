#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "calib/capture/inverse_depth_warp.h"
#include "render/faces/face_polygons.h"
#include "render/renderer/offscreen_renderer.h"
#include "render/subdivision/affine_pieces.h"
#include "render/transfer/polygon_clipping.h"
#include "render/transfer/scene_plane.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

/// Of the sides of polygons, those whose middle lies in the picture, and how many of these have a
/// line there.
struct ShownSides {
    int sides = 0;
    int shown = 0;
};

bool has_line_near(const ColorImage& picture, const Eigen::Vector2d& pixel) {
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int x = static_cast<int>(pixel.x()) + dx;
            const int y = static_cast<int>(pixel.y()) + dy;
            if (picture.contains(x, y) && picture(x, y) == Rgb8{255, 230, 26}) return true;
        }
    }
    return false;
}

ShownSides shown_sides(const std::vector<FacePolygon>& polygons, const ColorImage& picture) {
    ShownSides counted;
    for (const FacePolygon& polygon : polygons) {
        const std::vector<Eigen::Vector2d>& corners = polygon.corners_px;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Eigen::Vector2d middle = 0.5 * (corners[i] + corners[(i + 1) % corners.size()]);
            if (middle.minCoeff() < 2 || middle.x() > picture.width() - 2 ||
                middle.y() > picture.height() - 2)
                continue;
            ++counted.sides;
            counted.shown += has_line_near(picture, middle) ? 1 : 0;
        }
    }
    return counted;
}

void expect_sides_shown(const std::vector<FacePolygon>& polygons, const ColorImage& picture) {
    const ShownSides counted = shown_sides(polygons, picture);
    EXPECT_GT(counted.sides, 2);
    EXPECT_EQ(counted.shown, counted.sides);
}

Eye eye_at_card(const Eigen::Vector3d& position) {
    return eye_at(position, {0, 0, 3}, pinhole_camera(160, 120, 140));
}

TEST(FaceGrid, IsShownWhereTheLightFieldFadesBeyondTheCapture) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at_card({-0.3, 0.2, -1.5});
    const RenderOptions options{.mode = RenderMode::kLightField,
                                .debug_picture = DebugPicture::kGrid,
                                .fade_beyond_capture = true};
    expect_sides_shown(face_polygons(lumigraph.mesh, eye),
                       OffscreenRenderer(lumigraph).draw(eye, options).color);
}

TEST(FaceGrid, IsShownOfShells) {
    const Lumigraph lumigraph = card_with_close_ups();
    const Eye eye = eye_at_card({0.05, 0.02, 1.2});
    for (const RenderMode mode : {RenderMode::kLightField, RenderMode::kPerPixel}) {
        SCOPED_TRACE(name_of(mode));
        expect_sides_shown(face_polygons(lumigraph.mesh.shells.front(), eye, kNoOverlap_px),
                           OffscreenRenderer(lumigraph)
                               .draw(eye, {.mode = mode, .debug_picture = DebugPicture::kGrid})
                               .color);
    }
}

/// What the light field draws pixel by pixel.
std::vector<FacePolygon> exact_pieces(const Lumigraph& lumigraph, const Eye& eye) {
    const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
    std::vector<PlaneView> views;
    for (const LumigraphView& view : lumigraph.views) {
        views.push_back({warp_from(eye).to(view).homography_of(plane), 1.0 * view.camera.width_px,
                         1.0 * view.camera.height_px});
    }
    BlendTriangles affine;
    std::vector<FacePolygon> exact;
    for (FacePolygon polygon : face_polygons(lumigraph.mesh, eye)) {
        polygon.corners_px = clipped(polygon.corners_px, plane);
        cut_into_affine_pieces(polygon, views, plane, {}, affine, exact);
    }
    return exact;
}

TEST(FaceGrid, IsShownOfPiecesThatAreDrawnPixelByPixel) {
    const Lumigraph lumigraph = ball_in_sky();
    const Eye eye = eye_at({-0.3, -3, -0.5}, {0.7, 0.5, 0}, pinhole_camera(160, 120, 40));
    expect_sides_shown(
        exact_pieces(lumigraph, eye),
        OffscreenRenderer(lumigraph)
            .draw(eye, {.mode = RenderMode::kLightField, .debug_picture = DebugPicture::kGrid})
            .color);
}

}  // namespace
}  // namespace lumi
