#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/work/median.h"
#include "calib/work/progress.h"
#include "render/bench/budgeted_frames.h"
#include "render/bench/frame_timing.h"
#include "render/bench/lookup_count.h"
#include "render/bench/occlusion_share.h"
#include "render/bench/three_texture_blend.h"
#include "render/gl/capabilities.h"
#include "render/gl/draw_queries.h"
#include "render/gl/framebuffer.h"
#include "render/gl/headless_context.h"
#include "render/gl/lookup_meter.h"
#include "render/gl/texture.h"
#include "render/gl/vertex_buffer.h"
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

TEST(LookupMeterGl, TheBlendOfThreeTexturesLooksThreeTexelsUpForEachPixel) {
    const HeadlessContext context;
    const Lumigraph lumigraph = card_before_wall();
    Framebuffer framebuffer;
    framebuffer.attach_color(kWidthPx, kHeightPx);
    const Viewport viewport{0, 0, kWidthPx, kHeightPx};
    const auto drawn_by = [&](const ThreeTextureBlend& blend) {
        framebuffer.bind();
        blend.draw(viewport);
        return framebuffer.read_rgba_bottom_up(kWidthPx, kHeightPx);
    };
    const std::vector<unsigned char> plain = drawn_by(ThreeTextureBlend(lumigraph));
    const LookupMeter meter;
    const ThreeTextureBlend counting(lumigraph);
    EXPECT_EQ(drawn_by(counting), plain);
    const auto lookups = meter.lookups([&] { counting.draw(viewport); });
    if (!lookups) GTEST_SKIP() << "this context cannot count";
    EXPECT_EQ(*lookups, 3U * kWidthPx * kHeightPx);
    EXPECT_THAT(meter.lookups([] {}), Optional(0U));
}

TEST(UploadedBytesGl, AreThoseOfVerticesIndicesAndTexels) {
    const HeadlessContext context;
    EXPECT_EQ(uploaded_bytes([] {}), 0U);
    VertexBuffer buffer({{0, 2}});
    EXPECT_EQ(uploaded_bytes([&] {
                  buffer.upload({0, 0, 1, 0, 1, 1}, {0, 1, 2});
              }),
              6 * sizeof(float) + 3 * sizeof(std::uint32_t));
    TextureArray photographs(TexelFormat::kColor, TexelFilter::kLinear, 8, 4, 1);
    EXPECT_EQ(uploaded_bytes([&] { photographs.upload(0, ColorImage(8, 4)); }), 4U * 8 * 4);
    TextureArray depths(TexelFormat::kFloat, TexelFilter::kNearest, 8, 4, 1);
    EXPECT_EQ(uploaded_bytes([&] { depths.upload(0, FloatImage(8, 4)); }), 4U * 8 * 4);
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
        EXPECT_LE(mode.cost.cpu_ms, mode.cost.p95_cpu_ms);
        EXPECT_GT(mode.uploaded_bytes, 0);
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

/// Of each fragment: `lightfield` looks up no more than the three photographs of its face, one pass
/// of `paper2001` one; `perpixel` their depth, too.
TEST_F(FrameTimingGl, LookupsOfAFrameAreThoseOfItsFragments) {
    const std::vector<RenderOptions> modes{
        {.mode = RenderMode::kLightField, .guess_surroundings = false},
        {.mode = RenderMode::kPaper2001},
        {.mode = RenderMode::kPerPixel, .smooth_silhouettes = false, .guess_surroundings = false}};
    const FrameTimingReport report = timed(modes);
    const LookupCounts counts = count_lookups(
        lumigraph_, path_through_views(lumigraph_, kFrames, kWidthPx, kHeightPx), modes, progress_);
    if (!counts.base_per_pixel) GTEST_SKIP() << "this context cannot count";
    EXPECT_EQ(*counts.base_per_pixel, 3.0);
    const auto per_fragment = [&](std::size_t mode) {
        return *counts.modes_per_pixel[mode] / *report.modes[mode].fragments_per_pixel;
    };
    EXPECT_THAT(per_fragment(0), AllOf(Ge(1.0), Le(3.0)));
    EXPECT_DOUBLE_EQ(per_fragment(1), 1.0);
    EXPECT_GT(per_fragment(2), 3.0);
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
        EXPECT_EQ(with.color != without.color, corrects_occlusion(lumigraph_, {.mode = mode}))
            << name_of(mode);
    }
}

TEST_F(FrameTimingGl, OcclusionIsCorrectedByNoModeWithoutDepthOrOnAFocalPlane) {
    Lumigraph without_depth = lumigraph_;
    for (LumigraphView& view : without_depth.views) view.depth = {};
    OffscreenRenderer renderer(without_depth);
    const Eye eye = path_through_views(lumigraph_, 4, kWidthPx, kHeightPx)[1];
    for (const RenderMode mode : all_render_modes()) {
        EXPECT_FALSE(corrects_occlusion(without_depth, {.mode = mode})) << name_of(mode);
        EXPECT_EQ(renderer.draw(eye, {.mode = mode}).color,
                  renderer.draw(eye, {.mode = mode, .correct_occlusion = false}).color)
            << name_of(mode);
    }
    EXPECT_FALSE(corrects_occlusion(lumigraph_,
                                    {.mode = RenderMode::kHeigl, .focal_plane = {.depth = 4.0}}));
}

TEST_F(FrameTimingGl, AMovingEyesFrameIsMadeAnewAndIsTheSamePicture) {
    OffscreenRenderer renderer(lumigraph_);
    const Eye eye = path_through_views(lumigraph_, 4, kWidthPx, kHeightPx)[1];
    const RenderOptions options{.mode = RenderMode::kAdaptive};
    const Frame first = renderer.draw(eye, options);
    EXPECT_FALSE(first.statistics.are_triangles_kept);
    EXPECT_TRUE(renderer.draw(eye, options).statistics.are_triangles_kept);
    renderer.forget_frame();
    const Frame anew = renderer.draw(eye, options);
    EXPECT_FALSE(anew.statistics.are_triangles_kept);
    EXPECT_EQ(anew.color, first.color);
}

TEST_F(FrameTimingGl, FramesWithinBudgetsAreMadeAnewEachTime) {
    const Eye eye = path_through_views(lumigraph_, 4, kWidthPx, kHeightPx)[1];
    int frames = 0;
    draw_within_budgets(
        lumigraph_, {eye, eye}, {0.0},
        [&](const BudgetedFrame& frame) {
            EXPECT_FALSE(frame.statistics.are_triangles_kept);
            ++frames;
        },
        progress_);
    EXPECT_EQ(frames, 2);
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
