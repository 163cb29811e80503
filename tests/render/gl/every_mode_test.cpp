#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "render/renderer/mode_reference.h"
#include "render/renderer/offscreen_renderer.h"
#include "tests/render/analytic_scene.h"
#include "tests/render/frame_difference.h"

namespace lumi {
namespace {

/// Pixels on outlines fall to one side or the other by rounding: few, and in lines.
void expect_equal_pictures(const ColorImage& drawn, const ColorImage& expected,
                           const std::string& what) {
    const FrameDifference difference = difference_between(drawn, expected);
    EXPECT_LE(difference.mean, 1.0) << what;
    EXPECT_LE(difference.share_beyond_two, 0.01) << what;
    EXPECT_LE(difference.largest_of_patches, 4) << what;
}

void expect_equal_frames(const Frame& drawn, const Frame& expected, const std::string& what) {
    expect_equal_pictures(drawn.color, expected.color, what);
    expect_equal_pictures(as_color(drawn.coverage), as_color(expected.coverage),
                          what + ", coverage");
}

/// The card before the wall as large photographs show it, with a fine print that a mip level blurs
/// and the finest level does not; from the middle the card hides some of the wall from all cameras
/// but those at the right.
Lumigraph printed_card_in_large_photographs() {
    std::vector<Eye> cameras;
    for (const auto& [x, y] :
         {std::pair(-1.0, -0.5), std::pair(-1.1, 0.5), std::pair(-0.4, 0.6), std::pair(-0.3, -0.6),
          std::pair(-0.5, 0.0), std::pair(0.9, -0.5), std::pair(1.0, 0.6)})
        cameras.push_back(eye_at({x, y, 0}, {0.3 * x, 0, 4}, pinhole_camera(240, 180, 230)));
    Lumigraph lumigraph = photographed(AnalyticScene::kPrintedCard, cameras);
    lumigraph.drawing.depth_views = kLeastDepthViews;
    lumigraph.drawing.fills_holes = true;
    return lumigraph;
}

TEST(EveryModeAgainstReference, InFramesSmallerThanPhotographs) {
    const Lumigraph lumigraph = printed_card_in_large_photographs();
    OffscreenRenderer renderer(lumigraph);
    for (const int divisor : {1, 2, 3, 8}) {
        const Camera camera = pinhole_camera(240 / divisor, 180 / divisor, 230.0 / divisor);
        const Eye eye = eye_at({-0.2, 0.05, -0.1}, {0, 0, 4}, camera);
        for (const RenderMode mode : all_render_modes())
            expect_equal_frames(renderer.draw(eye, {.mode = mode}),
                                draw_mode_reference(lumigraph, eye, {.mode = mode}),
                                name_of(mode) + " at 1/" + std::to_string(divisor));
    }
}

TEST(EveryModeAgainstReference, FromFarAway) {
    const Lumigraph lumigraph = printed_card_in_large_photographs();
    OffscreenRenderer renderer(lumigraph);
    for (const double distance : {6.0, 20.0, 90.0}) {
        // 15 pixels a unit, a quarter of what photographs have.
        const Camera long_lens = pinhole_camera(80, 60, 15 * (distance + 4));
        const Eye eye = eye_at({-0.2, 0.05, -distance}, {0, 0, 4}, long_lens);
        for (const RenderMode mode : all_render_modes())
            expect_equal_frames(renderer.draw(eye, {.mode = mode}),
                                draw_mode_reference(lumigraph, eye, {.mode = mode}),
                                name_of(mode) + " from " + std::to_string(distance));
    }
}

TEST(EveryModeAgainstReference, InEveryDebugPicture) {
    const Lumigraph lumigraph = printed_card_in_large_photographs();
    OffscreenRenderer renderer(lumigraph);
    const Eye eye = eye_at({-0.2, 0.05, -0.1}, {0, 0, 4}, pinhole_camera(160, 120, 130));
    for (const RenderMode mode : all_render_modes()) {
        for (const DebugPicture picture : all_debug_pictures()) {
            if (picture == DebugPicture::kGrid) continue;
            const RenderOptions options{.mode = mode, .debug_picture = picture};
            expect_equal_frames(renderer.draw(eye, options),
                                draw_mode_reference(lumigraph, eye, options),
                                name_of(mode) + ", " + name_of(picture));
        }
    }
}

TEST(EveryModeAgainstReference, InPicturesOfWeightsAndDepthThatAnEyeSeesAtAnAngle) {
    for (const Lumigraph& lumigraph : {card_before_wall(), card_with_close_ups()}) {
        OffscreenRenderer renderer(lumigraph);
        for (const Eye& eye :
             {eye_at({2.2, 0.4, 1.5}, {0, 0, 4.5}, pinhole_camera(160, 120, 150)),
              eye_at({0.3, 0.2, 4.6}, {1.5, -0.4, 5}, pinhole_camera(160, 120, 150)),
              eye_at({0.05, 0.02, 1.9}, {0, 0, 3}, pinhole_camera(160, 120, 150))}) {
            for (const DebugPicture picture :
                 {DebugPicture::kWeights, DebugPicture::kDepth, DebugPicture::kOcclusion}) {
                const RenderOptions options{.mode = RenderMode::kLightField,
                                            .debug_picture = picture};
                expect_equal_frames(renderer.draw(eye, options),
                                    draw_mode_reference(lumigraph, eye, options), name_of(picture));
            }
        }
    }
}

TEST(EveryModeAgainstReference, AmidTheScene) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    const Camera camera = pinhole_camera(160, 120, 132);
    for (const auto& [eye, where] :
         {std::pair(eye_at({0.676, -0.904, 5.539}, {0.825, -0.088, 6.098}, camera),
                    "where surfaces are stretched past the eye"),
          std::pair(eye_at({-0.4, -0.05, 2.983}, {-0.29, 0.26, 3.93}, camera),
                    "nearer to the card than depth is drawn"),
          std::pair(eye_at({0.1, 0.05, 4}, {2, 0.3, 5}, camera), "between card and wall")})
        for (const RenderMode mode : all_render_modes())
            expect_equal_frames(renderer.draw(eye, {.mode = mode}),
                                draw_mode_reference(lumigraph, eye, {.mode = mode}),
                                name_of(mode) + ", " + where);
}

TEST(EveryModeAgainstReference, AtCamerasAndBesideThemBeyondTheirPhotographs) {
    const Camera wide = pinhole_camera(160, 120, 90);
    for (const Lumigraph& lumigraph : {ball_in_sky(), post_behind_post()}) {
        OffscreenRenderer renderer(lumigraph);
        for (const std::size_t number : {std::size_t{0}, lumigraph.views.size() - 1}) {
            const Rigid3& camera = lumigraph.views[number].cam_from_world;
            for (const double aside : {0.0, 1e-7, 1e-5, 1e-3}) {
                Eye eye{wide, camera};
                eye.cam_from_world.translation += Eigen::Vector3d(0.6, -0.64, 0.48) * aside;
                for (const RenderMode mode : {RenderMode::kLightField, RenderMode::kPerPixel,
                                              RenderMode::kAdaptive, RenderMode::kPaper2001})
                    expect_equal_frames(renderer.draw(eye, {.mode = mode}),
                                        draw_mode_reference(lumigraph, eye, {.mode = mode}),
                                        name_of(mode) + " aside by " + std::to_string(aside));
            }
        }
    }
}

TEST(EveryModeAgainstReference, AtCamerasInFramesWiderThanTheyLookAcross) {
    for (const Lumigraph& lumigraph : {card_before_wall(), ball_in_sky()}) {
        OffscreenRenderer renderer(lumigraph);
        // 106 degrees across, and 177 from corner to corner.
        for (const Camera& camera : {pinhole_camera(160, 120, 60), pinhole_camera(400, 20, 5)}) {
            const Eye eye{camera, lumigraph.views.front().cam_from_world};
            for (const RenderMode mode :
                 {RenderMode::kLightField, RenderMode::kPerPixel, RenderMode::kAdaptive})
                expect_equal_frames(renderer.draw(eye, {.mode = mode}),
                                    draw_mode_reference(lumigraph, eye, {.mode = mode}),
                                    name_of(mode) + " " + std::to_string(camera.width_px));
        }
    }
}

/// Nearly on an edge two views have nearly all weight; past both their photographs the third, which
/// has next to none, is all there is.
TEST(EveryModeAgainstReference, BesideAnEdgeOfTheMeshWhereTwoPhotographsEnd) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    const CameraMesh::Face& face = lumigraph.mesh.faces.front();
    const auto corner = [&](std::size_t k) {
        return lumigraph.mesh.vertices[static_cast<std::size_t>(face[k])].position_in_world;
    };
    for (const double aside : {1e-5, 1e-4, 1e-3}) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3d on_edge = 0.5 * (corner((k + 1) % 3) + corner((k + 2) % 3));
            const Eigen::Vector3d place = on_edge + aside * (corner(k) - on_edge);
            const Eye eye =
                eye_at(place, place + Eigen::Vector3d(0.2, 0.1, 4), pinhole_camera(160, 120, 60));
            const RenderOptions options{.mode = RenderMode::kLightField};
            const Frame drawn = renderer.draw(eye, options);
            const Frame expected = draw_mode_reference(lumigraph, eye, options);
            EXPECT_LE(difference_between(drawn.color, expected.color).share_beyond_two, 0.002)
                << aside << ' ' << k;
            EXPECT_LE(difference_between(as_color(drawn.coverage), as_color(expected.coverage))
                          .share_beyond_two,
                      0.002)
                << aside << ' ' << k;
        }
    }
}

TEST(EveryModeAgainstReference, InBlocksOfPixelsBeyondTheCapture) {
    Lumigraph lumigraph = card_before_wall();
    lumigraph.drawing.depth_block_px = kMaxDepthBlock_px;
    OffscreenRenderer renderer(lumigraph);
    for (const int width_px : {120, 119}) {
        const Eye eye = eye_at({2.6, -0.8, 3.4}, {1.5, 0.4, 5}, pinhole_camera(width_px, 90, 60));
        const Frame drawn = renderer.draw(eye, {});
        const FrameDifference difference =
            difference_between(drawn.color, draw_mode_reference(lumigraph, eye, {}).color);
        EXPECT_LE(difference.mean, 1.0) << width_px;
        EXPECT_LE(difference.share_beyond_two, 0.001) << width_px;
    }
}

/// What others show beyond a camera's photograph does not vanish where the eye comes to it.
TEST(LightFieldGl, ShowsAtACameraWhatItShowsALittleBehindIt) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    const RenderOptions options{.mode = RenderMode::kLightField};
    const Eigen::Vector3d camera = centre_in_world(lumigraph.views[0].cam_from_world);
    const Eigen::Vector3d back = (camera - lumigraph.mesh.scene_centre_in_world).normalized();
    const auto frame_at = [&](const Eigen::Vector3d& place) {
        // Turned aside, so that the camera's own photograph ends within the picture.
        return renderer.draw(
            eye_at(place, place + Eigen::Vector3d(2, 0.5, 4), pinhole_camera(160, 120, 160)),
            options);
    };
    const Frame at = frame_at(camera);
    for (const double behind : {1e-5, 1e-4, 1e-3}) {
        const Frame drawn = frame_at(camera + behind * back);
        const FrameDifference difference = difference_between(drawn.color, at.color);
        EXPECT_LE(difference.mean, 1.0) << behind;
        EXPECT_LE(difference.share_beyond_two, 0.02) << behind;
        EXPECT_LE(
            difference_between(as_color(drawn.coverage), as_color(at.coverage)).share_beyond_two,
            0.02)
            << behind;
    }
}

}  // namespace
}  // namespace lumi
