#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/work/median.h"
#include "calib/work/progress.h"
#include "render/bench/frame_timing.h"
#include "render/bench/occlusion_share.h"
#include "render/bench/three_texture_blend.h"
#include "render/gl/capabilities.h"
#include "render/gl/draw_queries.h"
#include "render/gl/framebuffer.h"
#include "render/gl/headless_context.h"
#include "render/paths/path_through_views.h"
#include "render/renderer/offscreen_renderer.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

using ::testing::AllOf;
using ::testing::Ge;
using ::testing::Le;
using ::testing::Optional;

constexpr int kWidthPx = 60;
constexpr int kHeightPx = 44;

TEST(FragmentCountGl, TheBlendOfThreeTexturesFillsEachPixelOnce) {
    const HeadlessContext context;
    const ThreeTextureBlend blend(card_before_wall());
    Framebuffer framebuffer;
    framebuffer.attach_color(kWidthPx, kHeightPx);
    const auto draw = [&] { blend.draw({0, 0, kWidthPx, kHeightPx}); };
    EXPECT_THAT(fragment_count(draw), Optional(kWidthPx * kHeightPx));
    EXPECT_THAT(fragment_count([&] {
                    draw();
                    draw();
                }),
                Optional(2 * kWidthPx * kHeightPx));
    EXPECT_THAT(fragment_count([] {}), Optional(0));
}

TEST(DeviceTimeGl, IsThatOfAGraphicsCard) {
    const HeadlessContext context;
    const ThreeTextureBlend blend(card_before_wall());
    Framebuffer framebuffer;
    framebuffer.attach_color(kWidthPx, kHeightPx);
    const auto time_ms = device_time_ms([&] { blend.draw({0, 0, kWidthPx, kHeightPx}); });
    ASSERT_EQ(time_ms.has_value(), !query_capabilities().works_on_cpu);
    EXPECT_GT(time_ms.value_or(1), 0);
}

class FrameTimingGl : public testing::Test {
 protected:
    [[nodiscard]] FrameTimingReport timed(const std::vector<RenderOptions>& modes) const {
        return time_frames(lumigraph_, path_through_views(lumigraph_, kFrames, kWidthPx, kHeightPx),
                           modes, progress_);
    }

    static constexpr int kFrames = 5;
    const Lumigraph lumigraph_ = card_before_wall();
    mutable SilentProgress progress_;
};

TEST_F(FrameTimingGl, RatiosAreOfTheBlendDrawnInTheSameRun) {
    const FrameTimingReport report =
        timed({{.mode = RenderMode::kLightField}, {.mode = RenderMode::kAdaptive}});
    EXPECT_EQ(report.frames, kFrames);
    EXPECT_GE(report.threads, 1);
    EXPECT_GT(report.base.cpu_ms, 0);
    ASSERT_EQ(report.modes.size(), 2U);
    for (const ModeCost& mode : report.modes) {
        EXPECT_DOUBLE_EQ(mode.ratio, mode.cost.median_ms / report.base.median_ms);
        EXPECT_DOUBLE_EQ(mode.cpu_ratio, mode.cost.cpu_ms / report.base.cpu_ms);
        EXPECT_LE(mode.cost.median_ms, mode.cost.p95_ms);
        EXPECT_EQ(mode.device_ms.has_value(), report.base_device_ms.has_value());
        EXPECT_EQ(mode.frames_cpu_ms.size(), static_cast<std::size_t>(kFrames));
        EXPECT_DOUBLE_EQ(median_of(mode.frames_cpu_ms), mode.cost.cpu_ms);
        EXPECT_GT(mode.triangles, 0);
    }
}

/// Faces overlap by a hundredth of a pixel; in the corners of this path nothing is seen.
TEST_F(FrameTimingGl, TheLightFieldFillsNoPixelTwice) {
    const FrameTimingReport report =
        timed({{.mode = RenderMode::kLightField, .guess_surroundings = false}});
    EXPECT_THAT(report.modes.front().fragments_per_pixel, Optional(AllOf(Ge(0.8), Le(1.02))));
}

/// What other views see of a triangle in part is laid over it, beyond the photographs of its own.
TEST_F(FrameTimingGl, AdaptiveFillsTwiceWhatOtherViewsSeeInPartAlone) {
    const FrameTimingReport report =
        timed({{.mode = RenderMode::kAdaptive, .guess_surroundings = false}});
    EXPECT_THAT(report.modes.front().fragments_per_pixel, Optional(AllOf(Ge(0.8), Le(1.05))));
}

TEST_F(FrameTimingGl, ThreePassesFillThePictureThreeTimes) {
    const FrameTimingReport report = timed({{.mode = RenderMode::kPaper2001}});
    EXPECT_THAT(report.modes.front().fragments_per_pixel, Optional(AllOf(Ge(2.5), Le(3.3))));
}

TEST(OcclusionShare, IsTheMedianOfWhatEachFrameSaves) {
    EXPECT_DOUBLE_EQ(median_share_saved({4, 10, 2}, {3, 9, 3}), 0.1) << "0.25, 0.1, -0.5";
    EXPECT_DOUBLE_EQ(median_share_saved({100, 1, 1}, {50, 1, 1}), 0.0) << "of one long frame";
}

TEST_F(FrameTimingGl, OcclusionIsCorrectedByModesWithDepth) {
    OffscreenRenderer renderer(lumigraph_);
    const Eye eye = path_through_views(lumigraph_, 4, kWidthPx, kHeightPx)[1];
    for (const RenderMode mode : all_render_modes()) {
        const Frame with = renderer.draw(eye, {.mode = mode});
        const Frame without = renderer.draw(eye, {.mode = mode, .correct_occlusion = false});
        EXPECT_EQ(with.color != without.color, corrects_occlusion(mode)) << name_of(mode);
    }
}

TEST_F(FrameTimingGl, TexturesHoldAllPhotographsAndDepthMaps) {
    const FrameTimingReport report = timed({{.mode = RenderMode::kLightField}});
    std::size_t texels = 0;
    for (const LumigraphView& view : lumigraph_.views)
        texels += 2 * view.photograph.pixels().size();
    EXPECT_GE(report.texture_bytes, 4 * texels);
    EXPECT_LE(report.texture_bytes, 5 * texels);
}

}  // namespace
}  // namespace lumi
