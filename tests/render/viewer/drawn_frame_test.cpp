#include <gtest/gtest.h>

#include <vector>

#include "render/gl/headless_context.h"
#include "render/viewer/window_picture.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

TEST(WindowPictureGl, IsDrawnAnewForWhateverIsChosenAndNotForTheSame) {
    const SyntheticCapture scene = textured_box_scene();
    const Lumigraph lumigraph = exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
    const HeadlessContext context;
    WindowPicture picture(lumigraph);
    ViewerState state = first_state(lumigraph, {.mode = RenderMode::kAdaptive});
    FrameStatistics statistics;
    const auto frames = [&] { return statistics.recent_frames_ms.size(); };
    picture.draw_whole(state, {64, 48}, statistics);
    for (const RenderOptions& options :
         {RenderOptions{.mode = RenderMode::kPerPixel},
          RenderOptions{.mode = RenderMode::kAdaptive, .max_triangles = 50},
          RenderOptions{.mode = RenderMode::kAdaptive, .min_triangle_px = 30},
          RenderOptions{.mode = RenderMode::kLightField},
          RenderOptions{.mode = RenderMode::kLightField, .focal_plane = {.depth = 2}}}) {
        const std::size_t before = frames();
        state.render = options;
        picture.draw_whole(state, {64, 48}, statistics);
        EXPECT_EQ(frames(), before + 1);
        EXPECT_EQ(picture.drawn()->options, options);
        picture.draw_whole(state, {64, 48}, statistics);
        EXPECT_EQ(frames(), before + 1);
    }
}

}  // namespace
}  // namespace lumi
