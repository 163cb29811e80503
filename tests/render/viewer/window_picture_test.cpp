#include "render/viewer/window_picture.h"

#include <gtest/gtest.h>

#include "render/gl/headless_context.h"
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

}  // namespace
}  // namespace lumi
