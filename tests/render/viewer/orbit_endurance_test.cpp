#include "render/viewer/orbit_endurance.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <memory>

#include "calib/work/error.h"
#include "tests/render/viewer/xvfb_display.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

Lumigraph orbited_box() {
    const SyntheticCapture scene = textured_box_scene();
    return exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
}

/// Three photographs, of the shortest turns.
OrbitOptions short_orbit() {
    OrbitOptions options;
    options.round_s = 0.0;
    options.seconds = 3 * kShortestTurn_s;
    options.warm_up_s = 0.0;
    return options;
}

class Orbited : public testing::Test {
 protected:
    static void SetUpTestSuite() { display = std::make_unique<XvfbDisplay>(); }
    static void TearDownTestSuite() { display.reset(); }
    void SetUp() override {
        if (!display->is_running()) GTEST_SKIP() << "no Xvfb here: install the package xvfb";
    }

    static WindowOptions small() {
        WindowOptions options;
        options.width_px = 640;
        options.height_px = 480;
        return options;
    }

    static inline std::unique_ptr<XvfbDisplay> display;
};

TEST_F(Orbited, WindowTurnsAboutOnePhotographAfterTheOtherWithoutAnyGlError) {
    ViewerWindow window({orbited_box()}, small());
    SilentProgress progress;
    const OrbitReport report = orbit_window(window, 9, short_orbit(), progress);
    EXPECT_EQ(window.state().view_index, 3);
    EXPECT_EQ(window.state().render.mode, RenderMode::kAdaptive) << "the second of two";
    EXPECT_GE(report.frames, 12) << "a key, two drags and a rest each";
    EXPECT_GT(report.median_frame_ms, 0.0);
    EXPECT_GE(report.p95_frame_ms, report.median_frame_ms);
    EXPECT_GE(report.longest_frame_ms, report.p95_frame_ms);
    EXPECT_EQ(report.gl_errors, 0);
    ASSERT_EQ(report.memory.size(), 3U);
    EXPECT_GT(report.memory.front().bytes, 1U << 20);
    EXPECT_GT(report.memory.front().moving_bytes, 1U << 20);
}

TEST_F(Orbited, WindowFollowsDragsThatAreShorterThanAFrame) {
    ViewerWindow window({orbited_box()}, small());
    SilentProgress progress;
    OrbitOptions options = short_orbit();
    options.seconds = kShortestTurn_s;
    options.modes.assign(100, RenderMode::kPerPixel);
    EXPECT_GE(orbit_window(window, 9, options, progress).frames, 200);
}

TEST_F(Orbited, WindowCountsGlErrors) {
    ViewerWindow window({orbited_box()}, small());
    SilentProgress progress;
    ASSERT_TRUE(window.step());
    glEnable(GL_INVALID_ENUM);
    EXPECT_EQ(orbit_window(window, 9, short_orbit(), progress).gl_errors, 1);
}

TEST_F(Orbited, WindowStopsWhenItIsInterrupted) {
    ViewerWindow window({orbited_box()}, small());
    SilentProgress progress;
    progress.interrupt();
    EXPECT_THROW((void)orbit_window(window, 9, short_orbit(), progress), Error);
}

TEST_F(Orbited, WindowThatIsClosedIsNoMeasurement) {
    ViewerWindow window({orbited_box()}, small());
    window.state().wants_to_close = true;
    SilentProgress progress;
    try {
        (void)orbit_window(window, 9, short_orbit(), progress);
        FAIL() << "a window that was closed";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-ORBIT-CLOSED");
    }
}

TEST(OrbitReport, CountsWhatMemoryGrewByAfterTheWarmUp) {
    OrbitReport report;
    report.memory = {{10.0, 0, 100}, {20.0, 0, 500}, {30.0, 0, 900}, {40.0, 0, 700}};
    EXPECT_EQ(report.growth_bytes(0.0), 600);
    EXPECT_EQ(report.growth_bytes(15.0), 200);
    EXPECT_EQ(report.growth_bytes(25.0), -200);
    EXPECT_EQ(report.growth_bytes(35.0), std::nullopt) << "one alone";
    EXPECT_EQ(report.growth_bytes(50.0), std::nullopt);
    EXPECT_EQ(OrbitReport{}.growth_bytes(0.0), std::nullopt);
}

}  // namespace
}  // namespace lumi
