#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <future>
#include <memory>
#include <thread>

#include "calib/work/error.h"
#include "render/depth_mesh/view_depth_mesh.h"
#include "render/gl/framebuffer.h"
#include "render/gl/headless_context.h"
#include "render/gl/to_glm.h"
#include "render/lumigraph/package.h"
#include "render/renderer/lumigraph_renderer.h"
#include "render/renderer/mode_reference.h"
#include "render/renderer/offscreen_renderer.h"
#include "render/transfer/view_geometry.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/analytic_scene.h"
#include "tests/render/frame_difference.h"

namespace lumi {
namespace {

Eye eye_of(const LumigraphView& view) { return {view.camera, view.cam_from_world}; }

std::string text_of(const RenderOptions& options) {
    return name_of(options.mode) + (options.supersample ? ", four samples a pixel" : "");
}

void expect_photograph(const ColorImage& drawn, const LumigraphView& view,
                       const RenderOptions& options, const std::string& by) {
    const FrameDifference difference = difference_between(drawn, view.photograph);
    const bool is_subdivided =
        options.mode == RenderMode::kAdaptive || options.mode == RenderMode::kPaper2001;
    // Texels are met at their centres; what is left is the rounding of the last bit, and where
    // triangles are, at silhouettes, what others show.
    if (is_subdivided)
        EXPECT_LE(difference.share_beyond_two, 0.03) << view.name << ' ' << text_of(options) << by;
    else
        EXPECT_LE(difference.largest, 1) << view.name << ' ' << text_of(options) << by;
}

/// In every way to draw them, and in plain code.
void expect_cameras_return_their_photographs(const Lumigraph& lumigraph) {
    OffscreenRenderer renderer(lumigraph);
    for (const LumigraphView& view : lumigraph.views) {
        const Eye eye = eye_of(view);
        for (const RenderMode mode : {RenderMode::kLightField, RenderMode::kPerPixel,
                                      RenderMode::kAdaptive, RenderMode::kPaper2001}) {
            for (const bool supersample : {false, true}) {
                const RenderOptions options{.mode = mode, .supersample = supersample};
                const Frame drawn = renderer.draw(eye, options);
                expect_photograph(drawn.color, view, options, " by OpenGL");
            }
            expect_photograph(draw_mode_reference(lumigraph, eye, {.mode = mode}).color, view,
                              {.mode = mode}, " in plain code");
        }
    }
    for (const RenderMode mode : {RenderMode::kLightField, RenderMode::kPerPixel})
        for (const LumigraphView& view : lumigraph.views)
            EXPECT_EQ(renderer.draw(eye_of(view), {.mode = mode}).coverage,
                      GrayImage(view.camera.width_px, view.camera.height_px, 255))
                << view.name << ' ' << name_of(mode);
}

TEST(LumigraphRendererGl, NovelViewAtACameraOfAnOpenMeshIsItsPhotograph) {
    expect_cameras_return_their_photographs(card_before_wall());
}

TEST(LumigraphRendererGl, NovelViewAtACameraOfAClosedMeshIsItsPhotograph) {
    expect_cameras_return_their_photographs(ball_in_sky());
}

TEST(LumigraphRendererGl, PhotographsMayDifferInSize) {
    std::vector<Eye> cameras;
    for (int i = 0; i < 5; ++i)
        cameras.push_back(eye_at({0.3 * i - 0.6, 0.2 * (i % 2), 0}, {0, 0, 4},
                                 pinhole_camera(40 + 9 * i, 60 - 7 * i, 50 + 3 * i)));
    expect_cameras_return_their_photographs(photographed(AnalyticScene::kCardBeforeWall, cameras));
}

TEST(LumigraphRendererGl, OnePhotographIsDrawnFromAlone) {
    const Eye camera = eye_at({0, 0, 0}, {0, 0, 4}, pinhole_camera(64, 48, 60));
    expect_cameras_return_their_photographs(photographed(AnalyticScene::kCardBeforeWall, {camera}));
}

TEST(LumigraphRendererGl, FourSamplesAPixelAreNeitherBrighterNorDarker) {
    const Lumigraph lumigraph = ball_in_sky();
    OffscreenRenderer renderer(lumigraph);
    for (const RenderMode mode : {RenderMode::kLightField, RenderMode::kPerPixel}) {
        const Eye eye = eye_of(lumigraph.views[1]);
        const Frame one = renderer.draw(eye, {.mode = mode});
        const Frame four = renderer.draw(eye, {.mode = mode, .supersample = true});
        double difference = 0;
        for (std::size_t i = 0; i < one.color.pixels().size(); ++i)
            difference += four.color.pixels()[i].g - one.color.pixels()[i].g;
        EXPECT_NEAR(difference / static_cast<double>(one.color.pixels().size()), 0, 0.3)
            << name_of(mode);
    }
}

TEST(LumigraphRendererGl, FourSamplesOfDepthAreNearlyAsGoodAsFourOfEverything) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    const Eye eye = eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(80, 60, 70));
    const ColorImage four = renderer.draw(eye, {.supersample = true}).color;
    const auto error_of = [&](const RenderOptions& options) {
        return difference_between(renderer.draw(eye, options).color, four).mean;
    };
    EXPECT_LT(error_of({}), 0.4 * error_of({.smooth_silhouettes = false}));
}

/// Every ray from within enters through some face, and the cameras see all of the ball and the sky
/// behind it, so nothing may stay empty.
TEST(LumigraphRendererGl, LeavesNoHoleWithinAClosedMesh) {
    OffscreenRenderer renderer(ball_in_sky());
    int eyes = 0;
    for (double angle = 0; angle < 6.2; angle += 0.37) {
        for (const double distance : {1.5, 2.1, 2.7, 3.0}) {
            const Eigen::Vector3d position =
                distance *
                Eigen::Vector3d(std::cos(angle), 0.4 * std::sin(3 * angle), std::sin(angle));
            const Eye eye = eye_at(position, {0, 0, 0}, pinhole_camera(40, 30, 60));
            for (const RenderMode mode : {RenderMode::kLightField, RenderMode::kPerPixel}) {
                const Frame drawn = renderer.draw(eye, {.mode = mode});
                const auto& pixels = drawn.color.pixels();
                EXPECT_EQ(std::count(pixels.begin(), pixels.end(), Rgb8{}), 0)
                    << name_of(mode) << " at " << position.transpose();
            }
            ++eyes;
        }
    }
    EXPECT_EQ(eyes, 68);
}

/// The ball in large photographs, red before black.
Lumigraph red_ball() {
    Lumigraph lumigraph = ball_in_sky();
    std::vector<Eye> cameras;
    for (const LumigraphView& view : lumigraph.views)
        cameras.push_back(
            {resized(view.camera, 8 * view.camera.width_px, 8 * view.camera.height_px),
             view.cam_from_world});
    lumigraph.views = photographed(AnalyticScene::kBallInSky, cameras).views;
    for (LumigraphView& view : lumigraph.views)
        for (int y = 0; y < view.photograph.height(); ++y)
            for (int x = 0; x < view.photograph.width(); ++x)
                view.photograph(x, y) =
                    view.depth.inverse_depth(x, y) > 0.0F ? Rgb8{200, 0, 0} : Rgb8{};
    return lumigraph;
}

/// Pixels that are drawn as guesses, and those of them that show the ball.
std::array<int, 2> guesses_of(const Lumigraph& lumigraph) {
    OffscreenRenderer renderer(lumigraph);
    std::array<int, 2> counts{};
    for (double angle = 0; angle < 6.2; angle += 0.37) {
        const Eye eye = eye_at({3 * std::cos(angle), std::sin(3 * angle), 3 * std::sin(angle)},
                               {0, 0, 0}, pinhole_camera(80, 60, 90));
        const Frame drawn = renderer.draw(eye, {.mode = RenderMode::kPerPixel});
        for (std::size_t i = 0; i < drawn.coverage.pixels().size(); ++i) {
            if (drawn.coverage.pixels()[i] != 0) continue;
            ++counts[0];
            counts[1] += drawn.color.pixels()[i].r > 100 ? 1 : 0;
        }
    }
    return counts;
}

/// Where no photograph shows the sky behind the ball, the ball does not stand beside itself: what
/// stands before a guess hides it, and who sees past it, to the sky, tells what is there.
TEST(LumigraphRendererGl, CheckedGuessesShowNoSubjectBesideItself) {
    Lumigraph lumigraph = red_ball();
    const auto [guesses, red_guesses] = guesses_of(lumigraph);
    lumigraph.drawing.checks_guesses = true;
    const auto [checked, red_checked] = guesses_of(lumigraph);
    EXPECT_GT(red_guesses, 500);
    EXPECT_LT(red_checked, red_guesses / 10) << guesses << ' ' << checked;
}

/// Around the ball there is sky that no camera nearby has seen, because the ball is before it.
TEST(LumigraphRendererGl, MostOfWhatIsWrongIsAGuessAndNotCovered) {
    OffscreenRenderer renderer(ball_in_sky());
    long wrong = 0;
    long wrong_but_covered = 0;
    for (double angle = 0; angle < 6.2; angle += 0.37) {
        const Eye eye = eye_at({3 * std::cos(angle), std::sin(3 * angle), 3 * std::sin(angle)},
                               {0, 0, 0}, pinhole_camera(80, 60, 90));
        const Frame drawn = renderer.draw(eye, {.mode = RenderMode::kPerPixel});
        const ColorImage ideal = ideal_photograph(AnalyticScene::kBallInSky, eye);
        for (std::size_t i = 0; i < ideal.pixels().size(); ++i) {
            const Rgb8& a = drawn.color.pixels()[i];
            const Rgb8& b = ideal.pixels()[i];
            if (std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) < 150) continue;
            ++wrong;
            wrong_but_covered += drawn.coverage.pixels()[i] != 0 ? 1 : 0;
        }
    }
    EXPECT_GT(wrong, 1000);
    EXPECT_LT(wrong_but_covered, wrong / 2);
}

TEST(LumigraphRendererGl, APackageWithItsDepthMeshesIsDrawnAsOneWithout) {
    Lumigraph with = card_before_wall();
    Lumigraph without = with;
    SilentProgress progress;
    make_depth_meshes(with, 2, progress);
    const ScratchFolder scratch;
    write_package(scratch / "with.lumi", with, {});
    write_package(scratch / "without.lumi", without, {});
    with = read_package(scratch / "with.lumi");
    without = read_package(scratch / "without.lumi");
    ASSERT_TRUE(with.views[0].depth_mesh);
    ASSERT_FALSE(without.views[0].depth_mesh);
    EXPECT_EQ(depth_mesh_of(with.views[0], max_disparity_px(view_geometries(with)[0]), {}),
              with.views[0].depth_mesh);
    const Eye eye = eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(64, 48, 60));
    const RenderOptions options{.mode = RenderMode::kPerPixel};
    const Frame drawn = OffscreenRenderer(with).draw(eye, options);
    const Frame expected = OffscreenRenderer(without).draw(eye, options);
    EXPECT_EQ(drawn.color, expected.color);
    EXPECT_EQ(drawn.coverage, expected.coverage);
}

/// Each choice from how a Lumigraph comes, and back; but for holes, which holes_test.cpp has.
std::vector<DrawingChoices> choices_around(const DrawingChoices& as_made) {
    std::vector<DrawingChoices> all;
    const auto add = [&](const auto& change) {
        DrawingChoices changed = as_made;
        change(changed);
        all.push_back(changed);
    };
    add([](DrawingChoices& drawing) { drawing.occlusion_tolerance_px = 12; });
    add([](DrawingChoices& drawing) { drawing.depth_views = kLeastDepthViews; });
    add([](DrawingChoices& drawing) { drawing.depth_block_px = kMaxDepthBlock_px; });
    add([](DrawingChoices& drawing) { drawing.checks_guesses = true; });
    add([](DrawingChoices& drawing) { drawing.triangle_error_px = 4; });
    add([](DrawingChoices& drawing) { drawing.draws_thin = true; });
    all.push_back(as_made);
    return all;
}

/// A little to the side of a camera and much nearer to what it looks at, as wide.
Eye beside(const LumigraphView& view) {
    Eye eye = eye_of(view);
    eye.cam_from_world.translation += Eigen::Vector3d(0.21, 0.13, -0.4);
    return eye;
}

/// Before which something is thin.
Lumigraph bar_before_wall() {
    std::vector<Eye> cameras;
    for (const double x : {-0.4, 0.0, 0.4})
        for (const double y : {-0.3, 0.3})
            cameras.push_back(eye_at({x, y, 0}, {x, y, 4}, pinhole_camera(256, 192, 200)));
    return photographed(AnalyticScene::kBarBeforeWall, cameras);
}

TEST(LumigraphRendererGl, WhatIsChosenLaterIsDrawnAsIfItHadComeSo) {
    const std::vector<DrawingChoices> choices = choices_around({});
    std::vector<bool> is_visible(choices.size(), false);
    for (Lumigraph lumigraph : {card_before_wall(), bar_before_wall(), ball_in_sky()}) {
        OffscreenRenderer chosen(lumigraph);
        OffscreenRenderer as_made(lumigraph);
        const Eye eye = beside(lumigraph.views.front());
        for (std::size_t i = 0; i < choices.size(); ++i) {
            lumigraph.drawing = choices[i];
            OffscreenRenderer made(lumigraph);
            chosen.choose(choices[i]);
            for (const RenderMode mode : {RenderMode::kPerPixel, RenderMode::kAdaptive}) {
                const Frame expected = made.draw(eye, {.mode = mode});
                const Frame drawn = chosen.draw(eye, {.mode = mode});
                EXPECT_EQ(drawn.color, expected.color) << name_of(mode);
                EXPECT_EQ(drawn.coverage, expected.coverage) << name_of(mode);
                EXPECT_EQ(drawn.statistics.triangles, expected.statistics.triangles);
                if (!(as_made.draw(eye, {.mode = mode}).color == drawn.color)) is_visible[i] = true;
            }
        }
    }
    std::vector<bool> all_but_the_last(choices.size(), true);
    all_but_the_last.back() = false;
    EXPECT_EQ(is_visible, all_but_the_last);
}

TEST(LumigraphRendererGl, DepthTakesTheGhostsAway) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    const Eye eye = eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(64, 48, 60));
    const ColorImage truth = ideal_photograph(AnalyticScene::kCardBeforeWall, eye);
    const auto with_plane = renderer.draw(eye, {.mode = RenderMode::kLightField});
    const auto with_depth = renderer.draw(eye, {.mode = RenderMode::kPerPixel});
    // Silhouettes remain: the card's outline passes through some 120 of 3072 pixels.
    EXPECT_LT(difference_between(with_depth.color, truth).mean, 2.0);
    EXPECT_GT(difference_between(with_plane.color, truth).mean, 3.0);
}

/// A picture of a share of the rows and columns; each pixel the mean of its square, or one of it.
ColorImage reduced(const ColorImage& image, int factor, bool averages) {
    ColorImage small(image.width() / factor, image.height() / factor);
    for (int y = 0; y < small.height(); ++y) {
        for (int x = 0; x < small.width(); ++x) {
            std::array<int, 3> sum{};
            const int count = averages ? factor : 1;
            const int first = averages ? 0 : factor / 2;
            for (int i = 0; i < count * count; ++i) {
                const Rgb8& pixel =
                    image(factor * x + first + i % count, factor * y + first + i / count);
                sum[0] += pixel.r;
                sum[1] += pixel.g;
                sum[2] += pixel.b;
            }
            const auto mean = [&](int value) {
                return static_cast<std::uint8_t>(value / (count * count));
            };
            small(x, y) = {mean(sum[0]), mean(sum[1]), mean(sum[2])};
        }
    }
    return small;
}

TEST(LumigraphRendererGl, FromFarAwayPhotographsAreNotAliased) {
    std::vector<Eye> cameras;
    for (int i = 0; i < 6; ++i)
        cameras.push_back(eye_at({0.5 * std::cos(i), 0.5 * std::sin(i), 0}, {0, 0, 4},
                                 pinhole_camera(240, 180, 220)));
    const Lumigraph lumigraph = photographed(AnalyticScene::kPrintedCard, cameras);
    OffscreenRenderer renderer(lumigraph);
    constexpr int kFactor = 8;
    const Eye far = eye_at({0.1, 0.1, 0}, {0, 0, 4}, pinhole_camera(40, 30, 40));
    const Eye fine{resized(far.camera, 40 * kFactor, 30 * kFactor), far.cam_from_world};
    const ColorImage truth =
        reduced(ideal_photograph(AnalyticScene::kPrintedCard, fine), kFactor, true);
    for (const RenderMode mode :
         {RenderMode::kPerPixel, RenderMode::kAdaptive, RenderMode::kPaper2001}) {
        const ColorImage drawn = renderer.draw(far, {.mode = mode}).color;
        // One sample of each pixel from a fine picture is what the finest level would show.
        const ColorImage aliased =
            reduced(renderer.draw(fine, {.mode = mode}).color, kFactor, false);
        // Triangles leave more of the card's outline to itself.
        const double share = mode == RenderMode::kPerPixel ? 0.7 : 0.95;
        EXPECT_LT(difference_between(drawn, truth).mean,
                  share * difference_between(aliased, truth).mean)
            << name_of(mode) << ' ' << difference_between(drawn, truth).mean;
    }
}

TEST(LumigraphRendererGl, DrawsTheSamePictureIntoACornerOfALargerFramebuffer) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at({0.2, 0.1, 0}, {0, 0, 4}, pinhole_camera(64, 48, 60));
    const Frame expected = OffscreenRenderer(lumigraph).draw(eye, {});
    const HeadlessContext context;
    LumigraphRenderer renderer(lumigraph);
    Framebuffer framebuffer;
    framebuffer.attach_color(100, 90);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    renderer.draw(eye, {}, {20, 30, 64, 48});
    const auto rgba = framebuffer.read_rgba_bottom_up(100, 90);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            const auto at =
                4 * static_cast<std::size_t>((30 + framebuffer_row(y, 48)) * 100 + 20 + x);
            // Interpolation over other window coordinates may round the last bit otherwise.
            ASSERT_NEAR(rgba[at], expected.color(x, y).r, 1) << x << ' ' << y;
            ASSERT_NEAR(rgba[at + 1], expected.color(x, y).g, 1) << x << ' ' << y;
        }
    }
    EXPECT_EQ(rgba[4 * 29 * 100], 255) << "outside of the viewport";
}

/// As far as a package may have them.
TEST(LumigraphRendererGl, CamerasWithExtremeNumbersAreDrawnInEveryMode) {
    const Lumigraph wall = card_before_wall();
    const Eye eye = eye_at({0.2, 0.1, 0}, {0, 0, 4}, pinhole_camera(64, 48, 60));
    for (const std::vector<double>& parameters : {std::vector{0.064, 0.064, 32.0, 24.0},
                                                  {6.4e7, 6.4e7, 32.0, 24.0},
                                                  {0.064, 6.4e7, 32.0, 24.0},
                                                  {60.0, 60.0, 6.4e5, -6.4e5}}) {
        Lumigraph lumigraph = wall;
        lumigraph.views[0].camera.parameters = parameters;
        validate(lumigraph, "extreme");
        OffscreenRenderer renderer(lumigraph);
        for (const RenderMode mode : all_render_modes()) {
            EXPECT_GT(renderer.draw(eye, {.mode = mode}).statistics.triangles, 0U) << name_of(mode);
            for (const LumigraphView& view : {lumigraph.views[0], lumigraph.views[1]})
                static_cast<void>(renderer.draw(eye_of(view), {.mode = mode}));
        }
    }
}

TEST(LumigraphRendererGl, RefusesAnEyeWithALens) {
    OffscreenRenderer renderer(card_before_wall());
    Eye eye = eye_at({0, 0, 0}, {0, 0, 4}, pinhole_camera(64, 48, 60));
    eye.camera = {64, 48, LensModel::kSimpleRadial, {60, 32, 24, 0.1}};
    try {
        (void)renderer.draw(eye, {});
        FAIL() << "expected an error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-EYE-LENS");
    }
}

TEST(HeadlessContextGl, SeveralLiveSideBySide) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at({0.2, 0.1, 0}, {0, 0, 4}, pinhole_camera(64, 48, 60));
    OffscreenRenderer first(lumigraph);
    const Frame before = first.draw(eye, {});
    {
        OffscreenRenderer second(lumigraph);
        EXPECT_EQ(second.draw(eye, {}).color, before.color);
    }
    EXPECT_EQ(first.draw(eye, {}).color, before.color);
}

TEST(OffscreenRendererGl, GoesWhereItsContextIsNotToBeHad) {
    std::promise<std::unique_ptr<OffscreenRenderer>> made;
    std::promise<void> gone;
    // Its context stays this thread's.
    std::thread owner([&] {
        made.set_value(std::make_unique<OffscreenRenderer>(card_before_wall()));
        gone.get_future().wait();
    });
    std::unique_ptr<OffscreenRenderer> renderer = made.get_future().get();
    const Eye eye = eye_at({0.2, 0.1, 0}, {0, 0, 4}, pinhole_camera(64, 48, 60));
    EXPECT_THROW((void)renderer->draw(eye, {}), Error);
    renderer.reset();
    gone.set_value();
    owner.join();
}

decltype(epoxy_eglMakeCurrent) real_make_current = nullptr;
int refusals_to_come = 0;

/// What libepoxy calls in the driver's place.
EGLBoolean refuse_at_first(EGLDisplay display, EGLSurface draw, EGLSurface read,
                           EGLContext context) {
    if (context != EGL_NO_CONTEXT && refusals_to_come-- > 0) return EGL_FALSE;
    return real_make_current(display, draw, read, context);
}

/// For as long as it lives, so many contexts cannot be made current.
class RefusingDriver {
 public:
    explicit RefusingDriver(int refusals) {
        // libepoxy finds a function when it is first called.
        const HeadlessContext context;
        real_make_current = epoxy_eglMakeCurrent;
        refusals_to_come = refusals;
        epoxy_eglMakeCurrent = refuse_at_first;
    }
    ~RefusingDriver() { epoxy_eglMakeCurrent = real_make_current; }
    RefusingDriver(const RefusingDriver&) = delete;
    RefusingDriver& operator=(const RefusingDriver&) = delete;
};

TEST(HeadlessContextGl, GoesOnWhereAContextCannotBeMadeCurrent) {
    const RefusingDriver driver(1);
    const HeadlessContext context;
    EXPECT_NE(glGetString(GL_RENDERER), nullptr);
}

TEST(HeadlessContextGl, SaysOfEveryAttemptHowItEnded) {
    constexpr int kAll = 1000;
    const RefusingDriver driver(kAll);
    try {
        const HeadlessContext context;
        FAIL() << "expected an error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-GL-CONTEXT");
        const std::string message = error.what();
        int told = 0;
        for (std::size_t at = 0; (at = message.find("cannot be made current", at)) != message.npos;
             ++at)
            ++told;
        EXPECT_EQ(told, kAll - refusals_to_come) << message;
        EXPECT_GT(kAll - refusals_to_come, 1);
    }
}

/// A fresh process, because Mesa reads its environment once.
int exit_code_with_old_gl() {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("MESA_GL_VERSION_OVERRIDE", "3.0", 1);
    setenv("MESA_GLES_VERSION_OVERRIDE", "2.0", 1);
    try {
        const HeadlessContext context;
        return 0;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s: %s", error.code().c_str(), error.what());
        return error.exit_code();
    }
}

TEST(HeadlessContextGlDeathTest, RefusesOldOpenGlPolitely) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(std::exit(exit_code_with_old_gl()),
                testing::ExitedWithCode(static_cast<int>(ErrorKind::kResources)), "E-GL-CONTEXT");
}

}  // namespace
}  // namespace lumi
