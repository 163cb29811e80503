#include "render/viewer/window.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "render/paths/photograph_eye.h"
#include "render/renderer/frame_target.h"
#include "render/renderer/offscreen_renderer.h"
#include "render/viewer/comparison.h"
#include "render/viewer/difference_picture.h"
#include "render/viewer/glfw_window.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/viewer/xvfb_display.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

const Lumigraph& box() {
    static const Lumigraph lumigraph = [] {
        const SyntheticCapture scene = textured_box_scene();
        return exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
    }();
    return lumigraph;
}

WindowOptions small_window() {
    WindowOptions options;
    options.width_px = 320;
    options.height_px = 240;
    return options;
}

class Window : public testing::Test {
 protected:
    static void SetUpTestSuite() { display = std::make_unique<XvfbDisplay>(); }
    static void TearDownTestSuite() { display.reset(); }
    void SetUp() override {
        if (!display->is_running()) GTEST_SKIP() << "no Xvfb here: install the package xvfb";
    }

    /// The screenshot of the window and the frame drawn without one.
    void expect_equal_to_headless(const Lumigraph& lumigraph, WindowOptions options,
                                  const Eye& eye) {
        const ScratchFolder scratch;
        options.screenshot_path = scratch / "window.png";
        run_window({lumigraph}, options);
        const Frame headless = OffscreenRenderer(lumigraph).draw(eye, options.render);
        write_png(scratch / "headless.png", headless.color);
        EXPECT_EQ(read_whole_file(scratch / "window.png"),
                  read_whole_file(scratch / "headless.png"));
    }

    static std::unique_ptr<XvfbDisplay> display;
};

std::unique_ptr<XvfbDisplay> Window::display;

TEST_F(Window, ScreenshotEqualsTheHeadlessFrameByteForByte) {
    const LumigraphView& view = box().views[4];
    for (const RenderMode mode : all_render_modes()) {
        SCOPED_TRACE(name_of(mode));
        WindowOptions options;
        options.view_name = view.name;
        options.render.mode = mode;
        expect_equal_to_headless(box(), options, {view.camera, view.cam_from_world});
    }
}

TEST_F(Window, ScreenshotOfAnotherSizeEqualsTheHeadlessFrameOfThatSize) {
    const LumigraphView& view = box().views[0];
    WindowOptions options;
    options.width_px = 301;
    options.height_px = 203;
    expect_equal_to_headless(box(), options,
                             fitted_to({view.camera, view.cam_from_world}, 301, 203));
}

TEST_F(Window, ShowsAPhotographTakenOnItsSideUpright) {
    Lumigraph lumigraph = box();
    lumigraph.views[4].exif_orientation = 6;
    const ScratchFolder scratch;
    WindowOptions options;
    options.view_name = lumigraph.views[4].name;
    options.screenshot_path = scratch / "window.png";
    run_window({lumigraph}, options);

    const ColorImage turned = read_color_image(scratch / "window.png");
    const ColorImage& raw = lumigraph.views[4].photograph;
    ASSERT_EQ(turned.width(), raw.height());
    ASSERT_EQ(turned.height(), raw.width());
    // A view at a photograph is that photograph, up to the rounding of the blend.
    double difference = 0;
    for (int y = 0; y < raw.height(); ++y) {
        for (int x = 0; x < raw.width(); ++x) {
            difference += std::abs(raw(x, y).g - turned(raw.height() - 1 - y, x).g);
        }
    }
    EXPECT_LT(difference / static_cast<double>(raw.pixels().size()), 1.0);
}

TEST_F(Window, ScreenshotComesWithItsPose) {
    const ScratchFolder scratch;
    WindowOptions options;
    options.screenshot_path = scratch / "shot.png";
    run_window({box()}, options);
    const auto pose = nlohmann::json::parse(read_whole_text(scratch / "shot.json"));
    EXPECT_EQ(pose["camera"]["parameters"], box().views[0].camera.parameters);
}

TEST_F(Window, CopiesTheFrameToTheWindowPixelByPixel) {
    const GlfwWindow window(320, 240, "copy", false);
    LumigraphRenderer renderer(box());
    FrameTarget target;
    target.draw(renderer, fitted_to(eye_at(box().views[4]), 320, 240), {});
    const ColorImage drawn = target.read().color;
    target.show_in_window(320, 240);

    std::vector<Rgb8> shown(320 * 240);  // Rows from the bottom; not swapped to the front yet.
    glReadBuffer(GL_BACK);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, 320, 240, GL_RGB, GL_UNSIGNED_BYTE, shown.data());
    int different = 0;
    int black = 0;
    for (int y = 0; y < 240; ++y) {
        for (int x = 0; x < 320; ++x) {
            const Rgb8 pixel = shown[static_cast<std::size_t>((239 - y) * 320 + x)];
            different += pixel == drawn(x, y) ? 0 : 1;
            black += pixel == Rgb8{} ? 1 : 0;
        }
    }
    EXPECT_EQ(different, 0);
    EXPECT_LT(black, 320 * 240 / 10) << "the photograph covers the picture";
}

TEST_F(Window, TakesEventsInTheirOrderHoweverLateItIsAsked) {
    GlfwWindow window(320, 240, "events", false);
    (void)window.poll(0.0);
    // As GLFW calls back while events are polled.
    const GLFWcursorposfun moved = glfwSetCursorPosCallback(window.handle(), nullptr);
    const GLFWmousebuttonfun pressed = glfwSetMouseButtonCallback(window.handle(), nullptr);
    ASSERT_NE(moved, nullptr);
    ASSERT_NE(pressed, nullptr);
    moved(window.handle(), 10, 10);
    moved(window.handle(), 200, 100);
    pressed(window.handle(), GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS, 0);
    moved(window.handle(), 203, 104);
    pressed(window.handle(), GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE, 0);
    moved(window.handle(), 300, 200);
    const WindowInput input = window.poll(0.0);
    EXPECT_TRUE(input.left_button);
    EXPECT_EQ(input.drag_px, Eigen::Vector2d(3, 4));
}

TEST_F(Window, StepsAtRestAndMovingWithoutAnyGlError) {
    ViewerWindow window({box()}, small_window());
    for (const Command command :
         {Command::kHelp, Command::kShowWeights, Command::kShowDepth, Command::kShowConfidence,
          Command::kShowFaces, Command::kShowFaces, Command::kLightField, Command::kNextPhotograph,
          Command::kFrameAll, Command::kPanel}) {
        apply(command, box(), window.state());
        window.state().navigation = orbit(window.state().navigation, {5, 3});
        EXPECT_TRUE(window.step());
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
    EXPECT_EQ(window.statistics().width_px, 320);
    EXPECT_EQ(window.statistics().height_px, 240);
    EXPECT_GT(window.statistics().frame_ms, 0.0);
    window.state().wants_to_close = true;
    EXPECT_FALSE(window.step());
}

TEST_F(Window, ClosesWhenItIsInterrupted) {
    SilentProgress progress;
    progress.interrupt();
    WindowOptions options = small_window();
    options.progress = &progress;
    run_window({box()}, options);  // Comes back.
}

TEST_F(Window, RefusesAPhotographThatIsNotThere) {
    WindowOptions options;
    options.view_name = "no such photograph";
    EXPECT_THROW(run_window({box()}, options), Error);
}

std::vector<Rgb8> texels(unsigned texture, const ColorImage& like) {
    std::vector<Rgb8> read(like.pixels().size());
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, read.data());
    return read;
}

TEST_F(Window, ComparesWithAHeldOutPhotographAndShowsItsDifference) {
    const LumigraphView& view = box().views[4];
    const Eye eye{view.camera, view.cam_from_world};
    const ColorImage drawn = OffscreenRenderer(box()).draw(eye, {}).color;
    const std::vector<HeldOutView> held_out{{view.name, eye, view.photograph},
                                            {"as drawn", eye, drawn}};
    ViewerWindow window({.lumigraph = box(), .held_out = held_out}, small_window());
    ASSERT_TRUE(window.step());
    LumigraphRenderer renderer(box());
    Comparison comparison(held_out);
    ViewerState& state = window.state();
    EXPECT_FALSE(comparison.over_frame(state, 320, 240, renderer).has_value());

    go_to_held_out(0, held_out, box(), state);
    const auto photograph = comparison.over_frame(state, 320, 240, renderer);
    ASSERT_TRUE(photograph.has_value());
    EXPECT_EQ(texels(photograph->texture, view.photograph), view.photograph.pixels());

    state.shows_difference = true;
    const auto difference = comparison.over_frame(state, 320, 240, renderer);
    ASSERT_TRUE(difference.has_value());
    EXPECT_EQ(texels(difference->texture, drawn),
              difference_picture(drawn, view.photograph).pixels());

    go_to_held_out(1, held_out, box(), state);
    const auto nothing = comparison.over_frame(state, 320, 240, renderer);
    ASSERT_TRUE(nothing.has_value());
    for (const Rgb8& texel : texels(nothing->texture, drawn)) ASSERT_EQ(texel, Rgb8{});
    ASSERT_TRUE(window.step());

    state.navigation.eye.cam_from_world.translation.x() += 0.01;
    EXPECT_FALSE(comparison.over_frame(state, 320, 240, renderer).has_value());
    ASSERT_TRUE(window.step());
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Window, TellsHowAlikeAHeldOutPhotographIsAndAsksOnceForEachChange) {
    const LumigraphView& view = box().views[4];
    const Eye eye = eye_at(view);
    const std::vector<HeldOutView> held_out{{view.name, eye, view.photograph}};
    const Frame expected = OffscreenRenderer(box()).draw(eye, {});
    int asked = 0;
    const LikenessWords words = [&](const Frame& drawn, const HeldOutView& beside) {
        EXPECT_EQ(drawn.color, expected.color);
        EXPECT_EQ(drawn.coverage, expected.coverage);
        EXPECT_EQ(beside.name, view.name);
        return "alike " + std::to_string(++asked);
    };
    OpenedPackage opened{.lumigraph = box(), .held_out = held_out, .likeness_words = words};
    ViewerWindow window(std::move(opened), small_window());
    ASSERT_TRUE(window.step());
    EXPECT_EQ(asked, 0);
    go_to_held_out(0, held_out, box(), window.state());
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(window.step());
    EXPECT_EQ(asked, 1);
    window.state().compared_share = 0.3;
    window.state().render.debug_picture = DebugPicture::kDepth;  // It is the picture that counts.
    ASSERT_TRUE(window.step());
    EXPECT_EQ(asked, 1);

    LumigraphRenderer renderer(box());
    Comparison comparison(held_out, words);
    EXPECT_EQ(comparison.over_frame(window.state(), 320, 240, renderer)->likeness, "alike 2");
}

TEST(DifferencePicture, IsFourTimesTheDifferenceOfEachChannel) {
    ColorImage a(2, 1);
    ColorImage b(2, 1);
    a(0, 0) = {10, 200, 30};
    b(0, 0) = {12, 100, 30};
    EXPECT_EQ(difference_picture(a, b)(0, 0), (Rgb8{8, 255, 0}));
    EXPECT_EQ(difference_picture(b, a)(0, 0), (Rgb8{8, 255, 0}));
    EXPECT_EQ(difference_picture(a, b)(1, 0), Rgb8{});
}

TEST(FittedOverlay, CoversWhereThePictureLies) {
    const Eye eye{pinhole_camera(640, 480, 500), {}};
    const PictureOverlay same_shape = fitted_overlay(eye, 320, 240);
    EXPECT_LT(same_shape.low_px.norm(), 1e-9);
    EXPECT_LT((same_shape.high_px - Eigen::Vector2d(320, 240)).norm(), 1e-9);
    const PictureOverlay wider = fitted_overlay(eye, 400, 240);
    EXPECT_LT((wider.low_px - Eigen::Vector2d(40, 0)).norm(), 1e-9);
    EXPECT_LT((wider.high_px - Eigen::Vector2d(360, 240)).norm(), 1e-9);
}

TEST(FittedOverlay, ShowsOfAnEnlargedPictureWhatTheFrameHolds) {
    const Eye eye{pinhole_camera(640, 480, 500), {}};
    const Enlargement enlargement = enlarged_about({}, {0.25, 0.5}, 3.0);
    const PictureOverlay overlay = fitted_overlay(eye, 400, 240, enlargement);
    // The picture lay from 40 to 360; the place at the cursor stays.
    const double left = 100 - enlargement.times * 60;
    EXPECT_NEAR(overlay.low_px.x(), std::max(0.0, left), 1e-9);
    EXPECT_NEAR(overlay.high_px.x(), 400.0, 1e-9);
    const double cursor_share =
        (100 - overlay.low_px.x()) / (overlay.high_px.x() - overlay.low_px.x());
    const double texture_at_cursor =
        overlay.texture_low.x() +
        cursor_share * (overlay.texture_high.x() - overlay.texture_low.x());
    EXPECT_NEAR(texture_at_cursor, 60.0 / 320.0, 1e-9);
    EXPECT_NEAR((overlay.texture_high - overlay.texture_low).y(), 1 / enlargement.times, 1e-9);
}

/// In a process of its own: drivers read the variable once.
[[noreturn]] void exit_with_advice_without_opengl_3_3() {
    ::setenv("MESA_GL_VERSION_OVERRIDE", "3.1", 1);
    try {
        const GlfwWindow window(64, 48, "old", false);
        std::fputs("a window", stderr);
    } catch (const Error& error) {
        std::fputs(error.advice().c_str(), stderr);
    }
    std::exit(0);
}

using WindowDeathTest = Window;

TEST_F(WindowDeathTest, SaysWhatHelpsWhereTheDisplayHasNoOpenGl33) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(exit_with_advice_without_opengl_3_3(), testing::ExitedWithCode(0),
                "has no OpenGL 3.3.*LIBGL_ALWAYS_SOFTWARE=1.*lumi render");
}

TEST(WindowWithoutADisplay, SaysToDrawToFilesInstead) {
    // Runs in a test of its own process under ctest; here no display is left from another test.
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    try {
        run_window({box()}, {});
        FAIL() << "a window without a display";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-GL-CONTEXT");
        EXPECT_NE(error.advice().find("lumi render"), std::string::npos);
    }
}

}  // namespace
}  // namespace lumi
