#include "render/viewer/panels.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <optional>
#include <utility>
#include <vector>

#include "render/viewer/window.h"
#include "render/viewer/window_input.h"
#include "render/viewer/window_size.h"
#include "tests/render/viewer/xvfb_display.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

class PanelsTest : public testing::Test {
 protected:
    void SetUp() override {
        if (!display_.is_running()) GTEST_SKIP() << "no Xvfb here: install the package xvfb";
    }

    static Lumigraph box() {
        const SyntheticCapture scene = textured_box_scene();
        return exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
    }

    XvfbDisplay display_;
};

/// The panels alone.
class DrawnPanels {
 public:
    DrawnPanels(const Lumigraph& lumigraph, RenderMode mode)
        : lumigraph_(lumigraph), state_(first_state(lumigraph, {.mode = mode})) {}

    [[nodiscard]] std::vector<Rgb8> draw(const FrameStatistics& statistics) {
        // They need a few frames to find their sizes.
        for (int i = 0; i < 4; ++i) {
            glClearColor(0, 0, 0, 1);
            glClear(GL_COLOR_BUFFER_BIT);
            panels_.draw(lumigraph_, {}, std::nullopt, statistics, state_);
        }
        std::vector<Rgb8> pixels(std::size_t{kLeastWindowWidth_px} * kLeastWindowHeight_px);
        glReadBuffer(GL_BACK);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, kLeastWindowWidth_px, kLeastWindowHeight_px, GL_RGB, GL_UNSIGNED_BYTE,
                     pixels.data());
        return pixels;
    }

 private:
    GlfwWindow window_{kLeastWindowWidth_px, kLeastWindowHeight_px, "panels", false};
    Panels panels_{window_};
    const Lumigraph& lumigraph_;
    ViewerState state_;
};

std::size_t different_pixels(const std::vector<Rgb8>& a, const std::vector<Rgb8>& b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!(a[i] == b[i])) ++different;
    return different;
}

FrameStatistics frames_that_took(std::vector<float> ms) {
    FrameStatistics statistics;
    statistics.recent_frames_ms = std::move(ms);
    return statistics;
}

FrameStatistics frame_of_triangles(std::size_t triangles) {
    FrameStatistics statistics;
    statistics.triangles = triangles;
    return statistics;
}

TEST_F(PanelsTest, ShowTheTimesOfFramesAsAGraphFromTheBeginning) {
    const Lumigraph lumigraph = box();
    DrawnPanels panels(lumigraph, RenderMode::kPerPixel);
    const std::vector<Rgb8> rising = panels.draw(frames_that_took({10, 20, 30, 40}));
    EXPECT_EQ(different_pixels(rising, panels.draw(frames_that_took({10, 20, 30, 40}))), 0U);
    EXPECT_GT(different_pixels(rising, panels.draw(frames_that_took({40, 30, 20, 10}))), 100U);
}

TEST_F(PanelsTest, CountTrianglesWhereTheSceneIsCutIntoThem) {
    const Lumigraph lumigraph = box();
    for (const RenderMode mode : all_render_modes()) {
        DrawnPanels panels(lumigraph, mode);
        const std::size_t different = different_pixels(panels.draw(frame_of_triangles(11111)),
                                                       panels.draw(frame_of_triangles(88888)));
        EXPECT_EQ(different > 0, mode != RenderMode::kPerPixel) << name_of(mode);
    }
}

/// As if so long nothing had happened.
void let_pass(double seconds) { glfwSetTime(glfwGetTime() + seconds); }

TEST_F(PanelsTest, TellWhatHappenedForSomeSeconds) {
    const Lumigraph lumigraph = box();
    DrawnPanels panels(lumigraph, RenderMode::kPerPixel);
    FrameStatistics statistics;
    const std::vector<Rgb8> silent = panels.draw(statistics);
    statistics.tell("wrote a picture");
    const std::vector<Rgb8> told = panels.draw(statistics);
    EXPECT_GT(different_pixels(silent, told), 100U);
    let_pass(2.0);
    EXPECT_EQ(different_pixels(told, panels.draw(statistics)), 0U);
    let_pass(3.0);
    EXPECT_EQ(different_pixels(silent, panels.draw(statistics)), 0U);
    statistics.tell("wrote a picture");
    EXPECT_EQ(different_pixels(told, panels.draw(statistics)), 0U) << "once more the same";
}

TEST_F(PanelsTest, TellWhatFailedUntilSomebodyDoesSomething) {
    const Lumigraph lumigraph = box();
    DrawnPanels panels(lumigraph, RenderMode::kPerPixel);
    FrameStatistics statistics;
    const std::vector<Rgb8> silent = panels.draw(statistics);
    statistics.tell_failure("nothing was written");
    const std::vector<Rgb8> told = panels.draw(statistics);
    EXPECT_GT(different_pixels(silent, told), 100U);
    let_pass(60.0);
    EXPECT_EQ(different_pixels(told, panels.draw(statistics)), 0U);
    ImGui::GetIO().KeysDown[GLFW_KEY_X] = true;
    EXPECT_EQ(different_pixels(silent, panels.draw(statistics)), 0U);
}

TEST_F(PanelsTest, TakeTheMouseWhereTheyAreDrawn) {
    const Lumigraph lumigraph = box();
    GlfwWindow window(kLeastWindowWidth_px, kLeastWindowHeight_px, "panels", false);
    Panels panels(window);
    ViewerState state = first_state(lumigraph, {});
    const auto draw = [&] { panels.draw(lumigraph, {}, std::nullopt, {}, state); };
    for (int i = 0; i < 4; ++i) draw();
    EXPECT_TRUE(panels.takes_mouse(Eigen::Vector2d(100, 100)));
    EXPECT_FALSE(panels.takes_mouse(Eigen::Vector2d(600, 100)));
    state.shows_panel = false;
    draw();
    EXPECT_FALSE(panels.takes_mouse(Eigen::Vector2d(100, 100)));
}

TEST_F(PanelsTest, EscapeEndsNoProgramWhileAListIsOpen) {
    WindowOptions options;
    options.width_px = 320;
    options.height_px = 240;
    ViewerWindow window({box()}, options);
    WindowInput escape;
    escape.commands = {Command::kBack};
    ASSERT_TRUE(window.step());
    // As a click on a list does.
    ImGui::NewFrame();
    ImGui::OpenPopup("list");
    ImGui::EndFrame();
    EXPECT_TRUE(window.step(&escape));
    WindowInput control_q;
    control_q.commands = {Command::kQuit};
    EXPECT_FALSE(window.step(&control_q));
}

}  // namespace
}  // namespace lumi
