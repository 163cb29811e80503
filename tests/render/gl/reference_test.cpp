#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "calib/work/error.h"

#include "render/reference/reference_renderer.h"
#include "render/renderer/mode_reference.h"
#include "render/renderer/offscreen_renderer.h"
#include "tests/render/analytic_scene.h"
#include "tests/render/frame_difference.h"

namespace lumi {
namespace {

struct NamedEye {
    const char* name;
    Eye eye;
};

const Camera kEyeCamera = pinhole_camera(80, 60, 70);

std::vector<NamedEye> eyes_before_wall(const Lumigraph& lumigraph) {
    const Eigen::Vector3d centre(0, 0, 4);
    const auto camera_centre = [&](int i) {
        return centre_in_world(lumigraph.views[static_cast<std::size_t>(i)].cam_from_world);
    };
    return {
        {"between cameras", eye_at({0.21, 0.13, 0.02}, centre, kEyeCamera)},
        {"at a camera", eye_at(camera_centre(0), {0.3, 0.1, 4}, kEyeCamera)},
        {"on an edge", eye_at(0.5 * camera_centre(0) + 0.5 * camera_centre(5), centre, kEyeCamera)},
        {"behind the cameras", eye_at({-0.3, 0.2, -1.5}, centre, kEyeCamera)},
        {"nearer to the scene", eye_at({0.1, -0.1, 1.2}, centre, kEyeCamera)},
        {"beyond the border", eye_at({1.2, 0.3, 0.2}, centre, kEyeCamera)}};
}

std::vector<NamedEye> eyes_around_ball(const Lumigraph& lumigraph) {
    const Eigen::Vector3d centre(0, 0, 0);
    const Eigen::Vector3d camera = centre_in_world(lumigraph.views[3].cam_from_world);
    return {{"far outside", eye_at({1, -2, -7}, centre, kEyeCamera)},
            {"at a camera", eye_at(camera, {0.2, 0, 0.1}, kEyeCamera)},
            {"inside the mesh", eye_at({0.5, 0.6, -2}, centre, kEyeCamera)},
            {"inside, looking away", eye_at({0.3, 0.2, -1.6}, {1, 1, -9}, kEyeCamera)}};
}

void expect_gl_equals_reference(const Lumigraph& lumigraph, const std::vector<NamedEye>& eyes,
                                const RenderOptions& options, GlApi api) {
    OffscreenRenderer renderer(lumigraph, api);
    for (const auto& [name, eye] : eyes) {
        const Frame drawn = renderer.draw(eye, options);
        const Frame expected = draw_reference(lumigraph, eye, options);
        const FrameDifference difference = difference_between(drawn.color, expected.color);
        // Pixels on silhouettes fall to one side or the other by rounding.
        EXPECT_LE(difference.mean, 1.0) << name;
        EXPECT_LE(difference.share_beyond_two, 0.02) << name;
        const auto covered = std::count(expected.coverage.pixels().begin(),
                                        expected.coverage.pixels().end(), std::uint8_t{255});
        EXPECT_GT(covered, 1000) << name;
        long uneven = 0;
        for (std::size_t i = 0; i < drawn.coverage.pixels().size(); ++i)
            uneven += drawn.coverage.pixels()[i] != expected.coverage.pixels()[i] ? 1 : 0;
        EXPECT_LE(uneven, 48) << name;  // 1 % of 80 x 60
    }
}

double mean_of(const ColorImage& image) {
    double sum = 0;
    for (const auto& color : image.pixels()) sum += color.r + color.g + color.b;
    return sum / static_cast<double>(3 * image.pixels().size());
}

TEST(GlAgainstReference, LightFieldBeforeAWall) {
    const Lumigraph lumigraph = card_before_wall();
    expect_gl_equals_reference(lumigraph, eyes_before_wall(lumigraph),
                               {.mode = RenderMode::kLightField}, GlApi::kAny);
}

TEST(GlAgainstReference, ViewsTriangulatedForEachFrame) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    const Eye at_camera{lumigraph.views[0].camera, lumigraph.views[0].cam_from_world};
    for (const double focal_depth : {0.0, 5.0}) {
        const RenderOptions heigl{.mode = RenderMode::kHeigl,
                                  .focal_plane = {.depth = focal_depth}};
        for (const Eye& eye : {eyes_before_wall(lumigraph)[0].eye, at_camera}) {
            const Frame drawn = renderer.draw(eye, heigl);
            const FrameDifference difference =
                difference_between(drawn.color, draw_mode_reference(lumigraph, eye, heigl).color);
            EXPECT_LE(difference.mean, 1.0);
            EXPECT_LE(difference.share_beyond_two, 0.02);
            EXPECT_GT(mean_of(drawn.color), 20);
        }
        EXPECT_LE(
            difference_between(renderer.draw(at_camera, heigl).color, lumigraph.views[0].photograph)
                .largest,
            1);
    }
}

TEST(GlAgainstReference, DepthCorrectsViewsThatAreTriangulatedForEachFrame) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    const Eye eye = eyes_before_wall(lumigraph)[0].eye;
    const ColorImage truth = ideal_photograph(AnalyticScene::kCardBeforeWall, eye);
    const auto error = [&](double focal_depth) {
        return difference_between(renderer
                                      .draw(eye, {.mode = RenderMode::kHeigl,
                                                  .focal_plane = {.depth = focal_depth}})
                                      .color,
                                  truth)
            .mean;
    };
    for (const double plane : {3.0, 4.0, 6.0}) EXPECT_LT(error(0), error(plane)) << plane;
}

TEST(GlAgainstReference, WhatLiesOnTheFocalSurfaceIsSharp) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    // Beside the card the wall at z = 6 is all that is seen.
    const Eye eye = eye_at({0.21, 0.13, 0}, {0.21, 0.13, 4}, pinhole_camera(80, 60, 70));
    const ColorImage truth = ideal_photograph(AnalyticScene::kCardBeforeWall, eye);
    const auto error_at = [&](double focal_depth) {
        const RenderOptions options{.mode = RenderMode::kLightField,
                                    .focal_plane = {.depth = focal_depth}};
        const ColorImage drawn = renderer.draw(eye, options).color;
        EXPECT_LE(
            difference_between(drawn, draw_mode_reference(lumigraph, eye, options).color).mean,
            1.0);
        double error = 0;
        for (int y = 0; y < truth.height(); ++y)
            for (int x = 0; x < 12; ++x) error += std::abs(drawn(x, y).g - truth(x, y).g);
        return error;
    };
    EXPECT_LT(error_at(6), 0.5 * error_at(4));
    EXPECT_LT(error_at(6), 0.5 * error_at(12));
}

TEST(GlAgainstReference, WhatPlainCodeDoesNotDrawIsRefused) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eyes_before_wall(lumigraph).front().eye;
    for (const RenderOptions& options :
         {RenderOptions{.supersample = true}, RenderOptions{.debug_picture = DebugPicture::kGrid}})
        EXPECT_THROW(static_cast<void>(draw_mode_reference(lumigraph, eye, options)), Error);
}

TEST(GlAgainstReference, LightFieldWithoutASurface) {
    const Lumigraph lumigraph = card_without_surface();
    expect_gl_equals_reference(lumigraph, eyes_before_wall(lumigraph),
                               {.mode = RenderMode::kLightField}, GlApi::kAny);
}

TEST(GlAgainstReference, PerPixelWithoutASurface) {
    const Lumigraph lumigraph = card_without_surface();
    expect_gl_equals_reference(lumigraph, eyes_before_wall(lumigraph),
                               {.mode = RenderMode::kPerPixel}, GlApi::kAny);
}

TEST(GlAgainstReference, LightFieldAroundABall) {
    const Lumigraph lumigraph = ball_in_sky();
    expect_gl_equals_reference(lumigraph, eyes_around_ball(lumigraph),
                               {.mode = RenderMode::kLightField}, GlApi::kAny);
}

TEST(GlAgainstReference, PerPixelBeforeAWall) {
    const Lumigraph lumigraph = card_before_wall();
    expect_gl_equals_reference(lumigraph, eyes_before_wall(lumigraph),
                               {.mode = RenderMode::kPerPixel}, GlApi::kAny);
}

TEST(GlAgainstReference, WhereOneViewAloneSeesAPost) {
    const Lumigraph lumigraph = post_behind_post();
    const Eigen::Vector3d centre(0, 0, 4.5);
    const std::vector<NamedEye> eyes{{"before the far post", eye_at({0, 0, 0}, centre, kEyeCamera)},
                                     {"aside", eye_at({0.1, 0.05, 0.1}, centre, kEyeCamera)},
                                     {"nearer to two", eye_at({0.45, 0, 0}, centre, kEyeCamera)}};
    for (const RenderMode mode : {RenderMode::kPerPixel, RenderMode::kAdaptive}) {
        OffscreenRenderer renderer(lumigraph);
        for (const auto& [name, eye] : eyes) {
            const FrameDifference difference =
                difference_between(renderer.draw(eye, {.mode = mode}).color,
                                   draw_mode_reference(lumigraph, eye, {.mode = mode}).color);
            EXPECT_LE(difference.mean, 1.0) << name;
            EXPECT_LE(difference.share_beyond_two, 0.02) << name;
        }
    }
}

TEST(GlAgainstReference, FromFarAwayThroughALongLens) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    for (const double times_farther : {20.0, 200.0, 1500.0}) {
        const Eye eye = eye_at({0.05, 0.03, -4 * times_farther}, {0.05, 0.03, 4},
                               pinhole_camera(80, 60, 300 * times_farther));
        for (const RenderMode mode : {RenderMode::kPerPixel, RenderMode::kLightField}) {
            const FrameDifference difference =
                difference_between(renderer.draw(eye, {.mode = mode}).color,
                                   draw_mode_reference(lumigraph, eye, {.mode = mode}).color);
            EXPECT_LE(difference.mean, 1.0) << times_farther << ' ' << name_of(mode);
            EXPECT_LE(difference.share_beyond_two, 0.02) << times_farther << ' ' << name_of(mode);
        }
    }
}

TEST(GlAgainstReference, PerPixelAroundABall) {
    const Lumigraph lumigraph = ball_in_sky();
    expect_gl_equals_reference(lumigraph, eyes_around_ball(lumigraph),
                               {.mode = RenderMode::kPerPixel}, GlApi::kAny);
}

TEST(GlAgainstReference, PerPixelWithGuessesChecked) {
    Lumigraph lumigraph = ball_in_sky();
    const Eye far_outside = eyes_around_ball(lumigraph).front().eye;
    const ColorImage unchecked = draw_reference(lumigraph, far_outside, {}).color;
    lumigraph.drawing.checks_guesses = true;
    EXPECT_NE(draw_reference(lumigraph, far_outside, {}).color.pixels(), unchecked.pixels());
    expect_gl_equals_reference(lumigraph, eyes_around_ball(lumigraph),
                               {.mode = RenderMode::kPerPixel}, GlApi::kAny);
    lumigraph.drawing.depth_block_px = kMaxDepthBlock_px;
    expect_gl_equals_reference(lumigraph, eyes_around_ball(lumigraph),
                               {.mode = RenderMode::kPerPixel}, GlApi::kAny);
}

TEST(GlAgainstReference, PerPixelWhereDepthIsTrustedLess) {
    Lumigraph lumigraph = ball_in_sky();
    const Eye far_outside = eyes_around_ball(lumigraph).front().eye;
    const ColorImage trusted = draw_reference(lumigraph, far_outside, {}).color;
    lumigraph.drawing.occlusion_tolerance_px = kMostOcclusionTolerance_px;
    EXPECT_NE(draw_reference(lumigraph, far_outside, {}).color.pixels(), trusted.pixels());
    expect_gl_equals_reference(lumigraph, eyes_around_ball(lumigraph),
                               {.mode = RenderMode::kPerPixel}, GlApi::kAny);
}

TEST(GlAgainstReference, MipLevelsFromFarAway) {
    Lumigraph lumigraph = card_before_wall();
    const Camera close_lens = pinhole_camera(80, 60, 100);  // So that the wall fills the picture.
    const std::vector<NamedEye> eyes{
        {"twice as far", eye_at({0.1, 0.05, -5}, {0, 0, 4}, close_lens)},
        {"far away", eye_at({0.2, 0.1, -12}, {0, 0, 4}, pinhole_camera(80, 60, 150))}};
    for (const RenderMode mode : {RenderMode::kPerPixel, RenderMode::kLightField})
        expect_gl_equals_reference(lumigraph, eyes, {.mode = mode}, GlApi::kAny);
    lumigraph.drawing.depth_block_px = kMaxDepthBlock_px;
    expect_gl_equals_reference(lumigraph, eyes, {.mode = RenderMode::kPerPixel}, GlApi::kAny);
}

TEST(GlAgainstReference, PerPixelWithoutOcclusionCorrection) {
    const Lumigraph lumigraph = card_before_wall();
    expect_gl_equals_reference(lumigraph, eyes_before_wall(lumigraph),
                               {.mode = RenderMode::kPerPixel, .correct_occlusion = false},
                               GlApi::kAny);
}

TEST(GlAgainstReference, PerPixelWithTheFewestDepthViews) {
    Lumigraph lumigraph = card_before_wall();
    lumigraph.drawing.depth_views = kLeastDepthViews;
    expect_gl_equals_reference(lumigraph, eyes_before_wall(lumigraph),
                               {.mode = RenderMode::kPerPixel}, GlApi::kAny);
}

/// With `camera` instead of their own.
std::vector<NamedEye> with_camera(std::vector<NamedEye> eyes, const Camera& camera) {
    for (NamedEye& named : eyes) named.eye.camera = camera;
    return eyes;
}

TEST(GlAgainstReference, PerPixelInBlocks) {
    Lumigraph wall = card_before_wall();
    wall.drawing.depth_block_px = kMaxDepthBlock_px;
    const RenderOptions per_pixel{.mode = RenderMode::kPerPixel};
    expect_gl_equals_reference(wall, eyes_before_wall(wall), per_pixel, GlApi::kAny);
    expect_gl_equals_reference(wall, eyes_before_wall(wall), per_pixel, GlApi::kEs);
    Lumigraph ball = ball_in_sky();
    ball.drawing.depth_block_px = kMaxDepthBlock_px;
    expect_gl_equals_reference(ball, eyes_around_ball(ball), per_pixel, GlApi::kAny);
}

TEST(GlAgainstReference, PerPixelInBlocksThatReachBeyondAnOddFrame) {
    Lumigraph wall = card_before_wall();
    wall.drawing.depth_block_px = kMaxDepthBlock_px;
    const Camera odd = pinhole_camera(79, 59, 70);
    expect_gl_equals_reference(wall, with_camera(eyes_before_wall(wall), odd),
                               {.mode = RenderMode::kPerPixel}, GlApi::kAny);
}

TEST(GlAgainstReference, PerPixelInBlocksOfFourPixelsEachHasItsOwnColour) {
    Lumigraph wall = card_before_wall();
    const Eye eye = eyes_before_wall(wall).front().eye;
    const ColorImage alone = OffscreenRenderer(wall).draw(eye, {}).color;
    wall.drawing.depth_block_px = kMaxDepthBlock_px;
    const ColorImage together = OffscreenRenderer(wall).draw(eye, {}).color;
    const FrameDifference difference = difference_between(alone, together);
    EXPECT_GT(difference.mean, 0.0);
    // A block away from silhouettes differs by what its weights vary within: next to nothing.
    EXPECT_LE(difference.share_beyond_two, 0.1);
}

int darkest_of(const ColorImage& image) {
    int darkest = 255;
    for (const Rgb8& color : image.pixels())
        darkest = std::min({darkest, int{color.r}, int{color.g}, int{color.b}});
    return darkest;
}

TEST(GlAgainstReference, AWhiteSceneIsWhiteUpToTheBordersOfPhotographs) {
    Lumigraph wall = card_before_wall();
    for (LumigraphView& view : wall.views)
        std::fill(view.photograph.pixels().begin(), view.photograph.pixels().end(),
                  Rgb8{255, 255, 255});
    std::vector<NamedEye> eyes = eyes_before_wall(wall);
    for (const double distance : {3.0, 5.0, 9.0, 16.0})
        eyes.push_back({"from far away", eye_at({0.1, 0.05, -distance}, {0, 0, 4}, kEyeCamera)});
    eyes.push_back({"past the end of the mesh", eye_at({200, 0.1, -100}, {0, 0, 4}, kEyeCamera)});
    for (const double block_px : {kLeastDepthBlock_px, kMaxDepthBlock_px}) {
        wall.drawing.depth_block_px = block_px;
        OffscreenRenderer renderer(wall);
        for (const RenderMode mode :
             {RenderMode::kPerPixel, RenderMode::kLightField, RenderMode::kAdaptive})
            for (const auto& [name, eye] : eyes)
                EXPECT_GE(darkest_of(renderer.draw(eye, {.mode = mode}).color), 250)
                    << name << " at " << centre_in_world(eye.cam_from_world).z() << ", "
                    << name_of(mode) << ", blocks of " << block_px;
    }
}

TEST(GlAgainstReference, AWhiteSceneIsWhiteUpToTheBordersOfCoarseMipLevels) {
    Lumigraph wall = card_without_surface();
    for (LumigraphView& view : wall.views)
        std::fill(view.photograph.pixels().begin(), view.photograph.pixels().end(),
                  Rgb8{255, 255, 255});
    OffscreenRenderer renderer(wall);
    // The scene lies behind the eye, and photographs are looked up infinitely far away, where they
    // are large, at the mip level of the scene, which is small.
    for (const double x : {0.1, 0.4, 0.8}) {
        const Eye eye = eye_at({x, 0.05, 60}, {1.2 * x, 0.05, 70}, pinhole_camera(80, 60, 30));
        for (const RenderMode mode :
             {RenderMode::kPerPixel, RenderMode::kLightField, RenderMode::kAdaptive}) {
            EXPECT_GE(darkest_of(renderer.draw(eye, {.mode = mode}).color), 250)
                << x << ' ' << name_of(mode);
            EXPECT_GE(darkest_of(draw_mode_reference(wall, eye, {.mode = mode}).color), 250)
                << x << ' ' << name_of(mode) << " in plain code";
        }
    }
}

TEST(GlAgainstReference, PerPixelOfSeveralSamplesIsNeverDrawnInBlocks) {
    Lumigraph wall = card_before_wall();
    const Eye eye = eyes_before_wall(wall).front().eye;
    const RenderOptions supersampled{.supersample = true};
    const ColorImage alone = OffscreenRenderer(wall).draw(eye, supersampled).color;
    wall.drawing.depth_block_px = kMaxDepthBlock_px;
    EXPECT_EQ(OffscreenRenderer(wall).draw(eye, supersampled).color, alone);
}

std::vector<NamedEye> eyes_near_card() {
    const Eigen::Vector3d centre(0, 0, 3);
    return {{"between the close-ups", eye_at({0.02, 0.06, 2.25}, centre, kEyeCamera)},
            {"behind them", eye_at({0.05, 0, 1.2}, centre, kEyeCamera)},
            {"beside them", eye_at({0.5, 0.1, 2.0}, centre, kEyeCamera)},
            {"among the far cameras", eye_at({0.2, 0.1, 0}, centre, kEyeCamera)}};
}

TEST(GlAgainstReference, PerPixelWithCloseUpsInAShell) {
    const Lumigraph lumigraph = card_with_close_ups();
    ASSERT_EQ(lumigraph.mesh.shells.size(), 1U);
    expect_gl_equals_reference(lumigraph, eyes_near_card(), {.mode = RenderMode::kPerPixel},
                               GlApi::kAny);
}

TEST(GlAgainstReference, PerPixelInBlocksUnderAShell) {
    Lumigraph lumigraph = card_with_close_ups();
    lumigraph.drawing.depth_block_px = kMaxDepthBlock_px;
    expect_gl_equals_reference(lumigraph, eyes_near_card(), {.mode = RenderMode::kPerPixel},
                               GlApi::kAny);
}

void expect_fading_equals_reference(RenderMode mode) {
    const Lumigraph lumigraph = card_before_wall();
    std::vector<NamedEye> eyes = eyes_before_wall(lumigraph);
    eyes.push_back({"far beyond the border", eye_at({2.4, 0.3, 0.2}, {0, 0, 4}, kEyeCamera)});
    OffscreenRenderer renderer(lumigraph);
    const RenderOptions fading{.mode = mode, .fade_beyond_capture = true};
    double darkest = 1;
    for (const auto& [name, eye] : eyes) {
        const Frame drawn = renderer.draw(eye, fading);
        const Frame expected = draw_reference(lumigraph, eye, fading);
        const FrameDifference difference = difference_between(drawn.color, expected.color);
        EXPECT_LE(difference.mean, 1.0) << name;
        EXPECT_LE(difference.share_beyond_two, 0.02) << name;
        EXPECT_LE(difference_between(as_color(drawn.coverage), as_color(expected.coverage)).mean,
                  1.5)
            << name;
        const Frame plain = renderer.draw(eye, {.mode = mode, .guess_surroundings = false});
        if (mean_of(plain.color) > 0)
            darkest = std::min(darkest, mean_of(drawn.color) / mean_of(plain.color));
        if (std::string(name) == "at a camera") {
            // The middle of the picture is the camera's own ray.
            EXPECT_EQ(drawn.color(40, 30), plain.color(40, 30));
        }
    }
    EXPECT_LT(darkest, 0.7);
}

TEST(GlAgainstReference, PerPixelFadingBeyondTheCapture) {
    expect_fading_equals_reference(RenderMode::kPerPixel);
}

TEST(GlAgainstReference, LightFieldFadingBeyondTheCapture) {
    expect_fading_equals_reference(RenderMode::kLightField);
}

TEST(GlAgainstReference, LightFieldWithCloseUpsInAShell) {
    expect_gl_equals_reference(card_with_close_ups(), eyes_near_card(),
                               {.mode = RenderMode::kLightField}, GlApi::kAny);
}

/// What a shell is for: the print that far cameras cannot resolve is there, and nothing is lost
/// where the close-ups see nothing.
void expect_detail(RenderMode mode, double most_of_error) {
    const Lumigraph with_shell = card_with_close_ups();
    Lumigraph without = with_shell;
    without.mesh.shells.clear();
    const auto error_at = [mode](const Lumigraph& lumigraph, const Eye& eye) {
        const Frame frame = draw_reference(lumigraph, eye, {.mode = mode});
        return difference_between(frame.color, ideal_photograph(AnalyticScene::kPrintedCard, eye))
            .mean;
    };
    const std::vector<NamedEye> eyes = eyes_near_card();
    EXPECT_LT(error_at(with_shell, eyes[0].eye), most_of_error * error_at(without, eyes[0].eye));
    EXPECT_LT(error_at(with_shell, eyes[1].eye),
              std::min(1.0, 1.6 * most_of_error) * error_at(without, eyes[1].eye));
    for (const auto& [name, eye] : eyes)
        EXPECT_LE(error_at(with_shell, eye), 1.02 * error_at(without, eye) + 0.2) << name;
}

TEST(Shells, ShowTheDetailThatTheirCloseUpsSaw) {
    expect_detail(RenderMode::kPerPixel, 0.5);
    // On one plane the print is where it is not, and hardly better in detail.
    expect_detail(RenderMode::kLightField, 1.0);
}

TEST(GlAgainstReference, PerPixelOnOpenGlEs) {
    const Lumigraph lumigraph = card_before_wall();
    expect_gl_equals_reference(lumigraph, eyes_before_wall(lumigraph),
                               {.mode = RenderMode::kPerPixel}, GlApi::kEs);
}

TEST(GlAgainstReference, LightFieldOnOpenGlEs) {
    const Lumigraph lumigraph = ball_in_sky();
    expect_gl_equals_reference(lumigraph, eyes_around_ball(lumigraph),
                               {.mode = RenderMode::kLightField}, GlApi::kEs);
}

TEST(GlAgainstReference, EveryDebugPicture) {
    const Lumigraph lumigraph = card_before_wall();
    const std::vector<NamedEye> eyes{eyes_before_wall(lumigraph).front()};
    for (const DebugPicture picture :
         {DebugPicture::kWeights, DebugPicture::kFaces, DebugPicture::kDepth,
          DebugPicture::kConfidence, DebugPicture::kOcclusion}) {
        SCOPED_TRACE(name_of(picture));
        expect_gl_equals_reference(lumigraph, eyes, {.debug_picture = picture}, GlApi::kAny);
    }
}

TEST(GlDebugPictures, OcclusionIsSeenBesideTheCardAndNowhereElse) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eyes_before_wall(lumigraph).front().eye;
    OffscreenRenderer renderer(lumigraph);
    for (const RenderMode mode : {RenderMode::kPerPixel, RenderMode::kAdaptive}) {
        SCOPED_TRACE(name_of(mode));
        const auto share_lit = [&](bool correct_occlusion) {
            const Frame drawn = renderer.draw(eye, {.mode = mode,
                                                    .debug_picture = DebugPicture::kOcclusion,
                                                    .correct_occlusion = correct_occlusion});
            const auto& pixels = drawn.color.pixels();
            return static_cast<double>(std::count_if(pixels.begin(), pixels.end(),
                                                     [](const Rgb8& p) { return p.r > 25; })) /
                   static_cast<double>(pixels.size());
        };
        const double corrected = share_lit(true);
        const double uncorrected = share_lit(false);
        EXPECT_GT(corrected, uncorrected + 0.005);
        // Triangles spread it as far as they reach.
        EXPECT_LT(corrected, mode == RenderMode::kPerPixel ? 0.5 : 0.9);
    }
}

}  // namespace
}  // namespace lumi
