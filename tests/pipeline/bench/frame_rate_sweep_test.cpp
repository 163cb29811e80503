#include "pipeline/bench/frame_rate_sweep.h"

#include <gtest/gtest.h>

#include "pipeline/evaluate/image_metrics.h"
#include "render/renderer/offscreen_renderer.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

TEST(FrameRateSweep, GivesTrianglesAndAccuracyAwayForSpeedAndNothingWhereThereIsTime) {
    const SyntheticCapture scene = textured_box_scene();
    const Lumigraph lumigraph = exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
    // From between the cameras, where depth counts, as drawn at each pixel.
    OffscreenRenderer renderer(lumigraph);
    std::vector<HeldOutView> held_out;
    for (const double x : {0.1, 0.3}) {
        Eye eye{lumigraph.views[4].camera, lumigraph.views[4].cam_from_world};
        eye.cam_from_world.translation.x() += x;
        held_out.push_back({"held out", eye, renderer.draw(eye, {}).color});
    }
    SilentProgress progress;
    const std::vector<FrameRateFigures> sweep =
        sweep_frame_rates(lumigraph, held_out, {1e-3, 1e6}, progress);
    ASSERT_EQ(sweep.size(), 3U);
    const FrameRateFigures& any = sweep[0];
    const FrameRateFigures& slow = sweep[1];
    const FrameRateFigures& impossible = sweep[2];
    EXPECT_EQ(any.asked, 0.0);
    EXPECT_EQ(any.share_in_time, 1.0);

    EXPECT_EQ(slow.triangles, any.triangles);
    EXPECT_EQ(slow.psnr_db, any.psnr_db);
    EXPECT_EQ(slow.share_in_time, 1.0);

    EXPECT_LT(impossible.triangles, any.triangles) << "by how many, a busy machine's clock tells";
    EXPECT_LT(impossible.psnr_db, any.psnr_db);
    EXPECT_EQ(impossible.share_in_time, 0.0);
    EXPECT_LT(impossible.reached, 1e6);

    double sum_db = 0;
    for (const HeldOutView& view : held_out)
        sum_db += psnr_db(renderer.draw(view.eye, {.mode = RenderMode::kAdaptive}).color,
                          view.photograph);
    EXPECT_DOUBLE_EQ(any.psnr_db, sum_db / 2) << "as drawn without a budget";
}

}  // namespace
}  // namespace lumi
