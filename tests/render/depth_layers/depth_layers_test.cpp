#include "render/depth_layers/depth_layers.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "render/depth_layers/depth_kind_ranges.h"
#include "render/depth_layers/lone_surfaces.h"
#include "render/gl/framebuffer.h"
#include "render/gl/headless_context.h"
#include "render/modes/per_pixel.h"
#include "render/reference/reference_renderer.h"
#include "tests/render/analytic_scene.h"
#include "tests/render/frame_difference.h"

namespace lumi {
namespace {

constexpr int kLayers = 3;

/// Four a texel, of which the first are the layers.
std::vector<float> texels_of(const DepthLayers& layers) {
    const TextureArray& texture = layers.texture();
    std::vector<float> texels(texture.bytes() / sizeof(float));
    texture.bind(0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, layers.is_packed() ? GL_RGBA : GL_DEPTH_COMPONENT,
                  GL_FLOAT, texels.data());
    if (layers.is_packed()) return texels;
    const std::size_t texels_a_layer = texels.size() / kLayers;
    std::vector<float> packed(4 * texels_a_layer, 1.0F);
    for (std::size_t i = 0; i < texels.size(); ++i)
        packed[4 * (i % texels_a_layer) + i / texels_a_layer] = texels[i];
    return packed;
}

std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value); }

/// Depths, and whether what was seen is marked (behind_tears.h).
void expect_same(const Lumigraph& lumigraph, const Eye& eye) {
    const UploadedLumigraph uploaded(lumigraph);
    DepthLayers by_open_gl(uploaded, kLayers, DepthLayers::DrawnBy::kOpenGl);
    DepthLayers by_cores(uploaded, kLayers, DepthLayers::DrawnBy::kCores);
    const std::vector<DepthViewSet> sets{{{0, 1, 2}, 0.6}, {{3, 1, 2}, 0.4}};
    by_open_gl.draw(eye, sets);
    by_cores.draw(eye, sets);
    // Shaders settle lone surfaces when they look layers up, unless that is done before.
    std::vector<float> expected = texels_of(by_open_gl);
    settle_lone_surfaces(uploaded.layout.views, eye, sets, kLayers, by_open_gl.max_inverse_depth(),
                         by_open_gl.agreeing_depth(), expected);
    const std::vector<float> texels = texels_of(by_cores);
    ASSERT_EQ(texels.size(), expected.size());
    std::size_t unlike = 0;
    std::size_t known = 0;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const bool is_marked_alike = expected[i] >= static_cast<float>(kDepthKindStep) ||
                                     ((bits_of(texels[i]) ^ bits_of(expected[i])) & 1U) == 0;
        unlike += std::abs(texels[i] - expected[i]) > 1e-4F || !is_marked_alike ? 1U : 0U;
        known += expected[i] < 1.0F ? 1U : 0U;
    }
    const std::size_t in_layers = texels.size() / 4 * kLayers;
    EXPECT_GT(known, in_layers / 4);
    // Along the sides of triangles that end there.
    EXPECT_LT(unlike, in_layers / 200);
}

TEST(DepthLayersGl, AreTheSameByOpenGlAndByTheCores) {
    const HeadlessContext context(GlApi::kCore);
    const Camera camera = pinhole_camera(97, 71, 80);
    expect_same(card_before_wall(), eye_at({0.3, 0.2, 0.2}, {0, 0, 4}, camera));
    expect_same(card_before_wall(), eye_at({0.4, 0.3, 2.6}, {0, 0, 4}, camera));
    expect_same(ball_in_sky(), eye_at({0.3, 0.2, 2.2}, {0, 0, 0.2}, camera));
    expect_same(card_before_wall(),
                eye_at({0.05, 0.03, -800}, {0.05, 0.03, 4}, pinhole_camera(97, 71, 60'000)));
}

/// A fresh process, because Mesa reads its environment once.
[[noreturn]] void draw_with_open_gl_3_3_alone() {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
    setenv("MESA_EXTENSION_OVERRIDE", "-GL_ARB_ES2_compatibility", 1);
    const HeadlessContext context(GlApi::kCore);
    const UploadedLumigraph uploaded(card_before_wall());
    DepthLayers layers(uploaded, kLayers, DepthLayers::DrawnBy::kOpenGl);
    layers.draw(eye_at({0.3, 0.2, 0.2}, {0, 0, 4}, pinhole_camera(97, 71, 80)), {{{0, 1, 2}, 1.0}});
    std::exit(glGetError() == GL_NO_ERROR ? 0 : 1);
}

TEST(DepthLayersGlDeathTest, NeedNoMoreThanOpenGl33) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(draw_with_open_gl_3_3_alone(), testing::ExitedWithCode(0), "");
}

/// The frame of a mode, as the program sees it: rows from the bottom.
ColorImage frame_of(PerPixel& mode, const Eye& eye, const RenderOptions& options) {
    const int width = eye.camera.width_px;
    const int height = eye.camera.height_px;
    Framebuffer framebuffer;
    framebuffer.attach_color(width, height);
    framebuffer.bind();
    glViewport(0, 0, width, height);
    glClear(GL_COLOR_BUFFER_BIT);
    mode.draw(eye, options, {0, 0, width, height});
    const std::vector<unsigned char> rgba = framebuffer.read_rgba_bottom_up(width, height);
    ColorImage frame(width, height);
    for (std::size_t i = 0; i < frame.pixels().size(); ++i)
        frame.pixels()[i] = {rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]};
    return frame;
}

TEST(PerPixelGl, DrawsTheSameWithDepthByOpenGlAndByTheCores) {
    const HeadlessContext context;
    Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at({0.3, 0.2, 0.2}, {0, 0, 4}, pinhole_camera(61, 45, 55));
    for (const double block_px : {kLeastDepthBlock_px, kMaxDepthBlock_px}) {
        lumigraph.drawing.depth_block_px = block_px;
        const UploadedLumigraph uploaded(lumigraph);
        PerPixel by_open_gl(uploaded, DepthLayers::DrawnBy::kOpenGl);
        PerPixel by_cores(uploaded, DepthLayers::DrawnBy::kCores);
        for (const bool is_smooth : {false, true}) {
            const RenderOptions options{.smooth_silhouettes = is_smooth};
            const ColorImage frame = frame_of(by_open_gl, eye, options);
            EXPECT_GT(difference_between(frame, ColorImage(61, 45)).mean, 50);
            const FrameDifference difference =
                difference_between(frame_of(by_cores, eye, options), frame);
            EXPECT_LT(difference.mean, 0.1) << block_px << " " << is_smooth;
        }
    }
}

/// By how much a column is off at most, a few rows at its ends aside.
int largest_error_in_column(int column, const ColorImage& rows_from_bottom,
                            const ColorImage& truth) {
    constexpr int kEnds = 5;
    int largest = 0;
    for (int y = kEnds; y < truth.height() - kEnds; ++y) {
        const Rgb8& drawn = rows_from_bottom(column, truth.height() - 1 - y);
        largest = std::max({largest, std::abs(drawn.r - truth(column, y).r),
                            std::abs(drawn.g - truth(column, y).g)});
    }
    return largest;
}

void expect_far_post_drawn(GlApi api) {
    const HeadlessContext context(api);
    Lumigraph lumigraph = post_behind_post();
    const Eye eye = eye_at({0, 0, 0}, {0, 0, 4}, pinhole_camera(61, 45, 60));
    const ColorImage truth = ideal_photograph(AnalyticScene::kPostBehindPost, eye);
    for (const double block_px : {kLeastDepthBlock_px, kMaxDepthBlock_px}) {
        lumigraph.drawing.depth_block_px = block_px;
        const UploadedLumigraph uploaded(lumigraph);
        for (const auto drawn_by : {DepthLayers::DrawnBy::kOpenGl, DepthLayers::DrawnBy::kCores}) {
            PerPixel mode(uploaded, drawn_by);
            for (const bool is_smooth : {false, true}) {
                const ColorImage frame = frame_of(mode, eye, {.smooth_silhouettes = is_smooth});
                EXPECT_LT(largest_error_in_column(30, frame, truth), 4)
                    << block_px << (drawn_by == DepthLayers::DrawnBy::kCores) << is_smooth;
            }
        }
    }
}

TEST(PerPixelGl, DrawsWhatOneViewAloneSeesBeforeWhatOthersAgreeOn) {
    for (const GlApi api : {GlApi::kCore, GlApi::kEs}) expect_far_post_drawn(api);
}

/// The ball, of which no two views beside each other agree how near it is.
Lumigraph ball_of_three_depths() {
    Lumigraph lumigraph = ball_in_sky();
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i)
        for (float& inverse_depth : lumigraph.views[i].depth.inverse_depth.pixels())
            inverse_depth *= 1.0F - 0.1F * static_cast<float>(i % 3);
    return lumigraph;
}

ColorImage rows_from_bottom(const ColorImage& picture) {
    ColorImage turned(picture.width(), picture.height());
    for (int y = 0; y < picture.height(); ++y)
        std::copy_n(picture.row(y), picture.width(), turned.row(picture.height() - 1 - y));
    return turned;
}

/// Views agree on the sky, and look past what one of them sees of the ball at another's part of it.
TEST(PerPixelGl, SettlesLoneSurfacesBeforeTheSkyAlikeByOpenGlByTheCoresAndInPlainCode) {
    const HeadlessContext context;
    const Lumigraph lumigraph = ball_of_three_depths();
    const UploadedLumigraph uploaded(lumigraph);
    PerPixel by_open_gl(uploaded, DepthLayers::DrawnBy::kOpenGl);
    PerPixel by_cores(uploaded, DepthLayers::DrawnBy::kCores);
    const RenderOptions options{.smooth_silhouettes = false};
    for (double angle = 0; angle < 6.2; angle += 0.5) {
        const Eye eye = eye_at({2.6 * std::cos(angle), 0.4, 2.6 * std::sin(angle)}, {0, 0, 0},
                               pinhole_camera(80, 60, 60));
        const ColorImage frame = frame_of(by_cores, eye, options);
        EXPECT_LT(difference_between(frame_of(by_open_gl, eye, options), frame).mean, 0.1) << angle;
        const ColorImage expected = draw_reference(lumigraph, eye, options).color;
        EXPECT_LT(difference_between(frame, rows_from_bottom(expected)).mean, 0.3) << angle;
    }
}

TEST(PerPixelGl, DrawsSilhouettesInStepsWhereTexturesAreTooSmallForOthers) {
    const HeadlessContext context;
    const Lumigraph lumigraph = card_before_wall();
    UploadedLumigraph uploaded(lumigraph);
    const Eye eye = eye_at({0.3, 0.2, 0.2}, {0, 0, 4}, pinhole_camera(61, 45, 55));
    PerPixel mode(uploaded);
    const ColorImage smooth = frame_of(mode, eye, {});
    const ColorImage in_steps = frame_of(mode, eye, {.smooth_silhouettes = false});
    EXPECT_GT(difference_between(smooth, in_steps).mean, 0);
    uploaded.capabilities.max_texture_size_px = 2 * 61 - 1;
    EXPECT_EQ(difference_between(frame_of(mode, eye, {}), in_steps).mean, 0);
    uploaded.capabilities.max_texture_size_px = 2 * 61;
    EXPECT_EQ(difference_between(frame_of(mode, eye, {}), smooth).mean, 0);
}

TEST(DepthLayersGl, HoldLittleMoreThanWhatAnEyeCanSee) {
    const HeadlessContext context;
    const Lumigraph lumigraph = card_before_wall();
    const UploadedLumigraph uploaded(lumigraph);
    const std::vector<DepthViewSet> sets{{{0, 1, 2}, 1.0}};
    for (const auto drawn_by : {DepthLayers::DrawnBy::kOpenGl, DepthLayers::DrawnBy::kCores}) {
        DepthLayers layers(uploaded, kLayers, drawn_by);
        for (const double distance : {0.5, 2.0, 10.0}) {
            // The card is the nearest, at z = 3.
            const Eye eye = eye_at({0, 0, -distance}, {0, 0, 4}, pinhole_camera(80, 60, 70));
            layers.draw(eye, sets);
            EXPECT_GE(layers.max_inverse_depth(), 1 / (3 + distance)) << distance;
            // Surfaces that agree must be told apart from others, too.
            EXPECT_LE(layers.max_inverse_depth(), 30 / (3 + distance)) << distance;
        }
    }
}

}  // namespace
}  // namespace lumi
