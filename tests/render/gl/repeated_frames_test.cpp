#include <gtest/gtest.h>

#include "calib/work/error.h"
#include "render/renderer/offscreen_renderer.h"
#include "render/uploaded/photograph_lod.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

/// Frames so small that photographs are looked up at a mip level, for which several sets of views
/// are asked for depth, and a large one.
std::vector<Eye> eyes_of_several_sizes() {
    const Camera small = pinhole_camera(24, 18, 18);
    return {eye_at({0, 0, 0}, {0, 0, 4}, small), eye_at({0.21, 0.2, 0}, {0, 0, 4}, small),
            eye_at({0.3, 0, 0}, {0, 0, 4}, small),
            eye_at({0.21, 0, 0}, {0, 0, 4}, pinhole_camera(80, 60, 70))};
}

TEST(RepeatedFramesGl, AreTheSameWhateverWasDrawnBefore) {
    const Lumigraph lumigraph = card_before_wall();
    ASSERT_GT(photograph_lod(lumigraph, eyes_of_several_sizes().front()), 0);
    OffscreenRenderer used(lumigraph);
    for (const Eye& eye : eyes_of_several_sizes()) {
        for (const RenderMode mode :
             {RenderMode::kLightField, RenderMode::kPerPixel, RenderMode::kAdaptive}) {
            const Frame expected = OffscreenRenderer(lumigraph).draw(eye, {.mode = mode});
            for (int again = 0; again < 2; ++again) {
                const Frame drawn = used.draw(eye, {.mode = mode});
                EXPECT_EQ(drawn.color, expected.color) << name_of(mode);
                EXPECT_EQ(drawn.coverage, expected.coverage) << name_of(mode);
            }
        }
    }
}

TEST(RepeatedFramesGl, AreTheSameAfterOneThatDoesNotFit) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    const Eye eye = eye_at({0.2, 0.1, 0}, {0, 0, 4}, pinhole_camera(100, 80, 70));
    const Eye too_wide{resized(eye.camera, 1'000'000, 40), eye.cam_from_world};
    const Frame expected = renderer.draw(eye, {});
    try {
        (void)renderer.draw(too_wide, {});
        FAIL() << "expected E-GL-LIMIT";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-GL-LIMIT");
    }
    EXPECT_EQ(renderer.draw(eye, {}).color, expected.color);
}

}  // namespace
}  // namespace lumi
