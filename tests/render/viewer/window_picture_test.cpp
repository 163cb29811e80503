#include "render/viewer/window_picture.h"

#include <gtest/gtest.h>

#include "render/gl/headless_context.h"
#include "render/paths/photograph_eye.h"
#include "tests/render/gl/small_driver.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

TEST(WindowPictureGl, AFrameThatWasNotDrawnTeachesTheTimeBudgetNothing) {
    const SyntheticCapture scene = textured_box_scene();
    const Lumigraph lumigraph = exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
    const HeadlessContext context;
    WindowPicture picture(lumigraph);
    ViewerState state = first_state(lumigraph, {.mode = RenderMode::kAdaptive});
    state.frames_per_second = 1e-3;  // Every frame has time to spare.
    FrameStatistics statistics;
    picture.draw_moving(state, {64, 48}, statistics);
    ASSERT_GT(statistics.triangles, 0U);
    // The eye stands, and what is told of the last frame would be far too slow.
    statistics.triangles = 1'000'000;
    statistics.frame_ms = 1e9;
    for (int i = 0; i < 3; ++i) picture.draw_moving(state, {64, 48}, statistics);
    ASSERT_TRUE(picture.drawn().has_value());
    EXPECT_EQ(picture.drawn()->options.triangle_error_ratio, state.render.triangle_error_ratio);
    EXPECT_EQ(statistics.triangles, 1'000'000U) << "nothing was drawn again";
}

TEST(WindowPictureGl, AWindowLargerThanWhatTheDriverDrawsIsDrawnAsLargeAsItCan) {
    const SyntheticCapture scene = textured_box_scene();
    const Lumigraph lumigraph = exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
    const SmallDriver driver(256, 64);
    const HeadlessContext context;
    WindowPicture picture(lumigraph);
    const ViewerState state = first_state(lumigraph, {.mode = RenderMode::kLightField});
    FrameStatistics statistics;
    picture.draw_whole(state, {512, 384}, statistics);
    EXPECT_EQ(statistics.width_px, 256);
    EXPECT_EQ(statistics.height_px, 192);
    EXPECT_EQ(SmallDriver::refused(), 0);
}

TEST(WindowPictureGl, ShowsThePartOfThePictureThatIsEnlarged) {
    const SyntheticCapture scene = textured_box_scene();
    const Lumigraph lumigraph = exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
    const HeadlessContext context;
    WindowPicture picture(lumigraph);
    ViewerState state = first_state(lumigraph, {});
    go_to_photograph(4, lumigraph, state);
    state.enlargement = enlarged_about({}, {0.75, 0.5}, 3.0);
    FrameStatistics statistics;
    picture.draw_whole(state, {320, 240}, statistics);
    const Eye whole = fitted_to(state.navigation.eye, 320, 240);
    const Eye& drawn = picture.drawn()->eye;
    // What is under the cursor stays there; what is a pixel beside it is farther from it.
    const Eigen::Vector3d at_cursor = unproject(whole.camera, {240, 120});
    const Eigen::Vector3d beside = unproject(whole.camera, {241, 120});
    EXPECT_LT((project(drawn.camera, at_cursor).value() - Eigen::Vector2d(240, 120)).norm(), 1e-9);
    EXPECT_NEAR(project(drawn.camera, beside).value().x(), 240 + state.enlargement.times, 1e-9);
}

}  // namespace
}  // namespace lumi
