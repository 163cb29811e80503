#include "render/painters/blend_painter.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "render/gl/framebuffer.h"
#include "render/gl/headless_context.h"
#include "render/modes/paper2001.h"
#include "render/reference/triangle_reference.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr int kWidth_px = 64;
constexpr int kHeight_px = 48;
const Eye kBlendEye = eye_at({0, 0, 0}, {0, 0, 4}, pinhole_camera(kWidth_px, kHeight_px, 60));

/// Photographs of one grey each.
Lumigraph grey_photographs(std::uint8_t first, std::uint8_t others) {
    Lumigraph lumigraph = card_before_wall();
    for (LumigraphView& view : lumigraph.views) {
        const std::uint8_t grey = &view == &lumigraph.views.front() ? first : others;
        std::fill(view.photograph.pixels().begin(), view.photograph.pixels().end(),
                  Rgb8{grey, grey, grey});
    }
    return lumigraph;
}

struct Side {
    float confidence = 1.0F;
    float opacity = 1.0F;
};

/// One photograph over all of the picture, which varies from one side of it to the other.
BlendTriangles sheet(int view, const Side& left, const Side& right) {
    BlendTriangles triangles;
    for (const int y : {0, kHeight_px}) {
        for (const int x : {0, kWidth_px}) {
            BlendVertex vertex;
            vertex.pixel = {static_cast<float>(x), static_cast<float>(y)};
            vertex.view_pixels.fill({32.0F, 24.0F});
            vertex.weights = {1, 0, 0};
            vertex.view_layers.fill(static_cast<float>(view));
            vertex.confidence = x == 0 ? left.confidence : right.confidence;
            vertex.opacity = x == 0 ? left.opacity : right.opacity;
            triangles.vertices.push_back(vertex);
        }
    }
    triangles.indices = {0, 1, 3, 0, 3, 2};
    return triangles;
}

struct Laid {
    BlendTriangles triangles;
    Behind behind = Behind::kNothing;
};

/// Pixels of four bytes, drawn one over the other.
std::vector<unsigned char> pixels_of(const Lumigraph& lumigraph, const std::vector<Laid>& layers) {
    const HeadlessContext context;
    const UploadedLumigraph uploaded(lumigraph);
    BlendPainter painter(uploaded, kLeastConfidence);
    Framebuffer framebuffer;
    framebuffer.attach_color(kWidth_px, kHeight_px);
    glViewport(0, 0, kWidth_px, kHeight_px);
    glClear(GL_COLOR_BUFFER_BIT);
    for (const Laid& layer : layers) painter.draw(layer.triangles, kBlendEye, {}, layer.behind);
    return framebuffer.read_rgba_bottom_up(kWidth_px, kHeight_px);
}

TEST(BlendPainterGl, LaysOverAPictureAsOpaqueAsItIsWhereItIsAGuessToo) {
    const Lumigraph lumigraph = grey_photographs(150, 140);
    const BlendTriangles base = sheet(0, {}, {});
    const BlendTriangles shell = sheet(1, {0.0F, 0.0F}, {0.5F, 1.0F});
    const auto pixels = pixels_of(lumigraph, {{base}, {shell, Behind::kPicture}});
    const TriangleReference reference(lumigraph, kBlendEye, PlaceInterpolation::kLinear);
    Frame expected = empty_frame(kBlendEye.camera);
    reference.draw(base, expected);
    reference.lay_over(shell, expected);
    for (int x = 0; x < kWidth_px; ++x) {
        const auto at = 4 * static_cast<std::size_t>(x);
        EXPECT_NEAR(pixels[at], expected.color(x, 0).r, 1) << x;
        EXPECT_NEAR(pixels[at + 3], 255, 1) << "covered by either at " << x;
        EXPECT_EQ(expected.coverage(x, 0), 255) << x;
    }
}

TEST(BlendPainterGl, DoesNotCountAGuessAsCoveredThatFadesIntoBlack) {
    const auto pixels = pixels_of(grey_photographs(200, 200),
                                  {{sheet(0, {0.0F, 1.0F}, {0.0F, 0.0F}), Behind::kBlack}});
    for (int x = 0; x < kWidth_px; ++x) {
        const auto at = 4 * static_cast<std::size_t>(x);
        EXPECT_NEAR(pixels[at], 200 * (kWidth_px - x - 0.5) / kWidth_px, 1) << x;
        EXPECT_EQ(pixels[at + 3], 0) << x;
    }
}

/// Corners that lie behind one view have no place there, and no weight: of the others all is drawn.
TEST(Paper2001Gl, LooksPhotographsUpWhateverPlacesOthersLack) {
    const Lumigraph lumigraph = card_before_wall();
    BlendTriangles triangles = sheet(0, {}, {});
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    for (BlendVertex& corner : triangles.vertices) {
        corner.view_layers = {0, 1, 2};
        corner.view_pixels[0] = corner.pixel;
        corner.view_pixels[1] = {kNone, 7.0F};
        corner.view_pixels[2] = {std::numeric_limits<float>::infinity(), kNone};
        corner.depth_ratios = {1, 0, 0};
    }
    const HeadlessContext context;
    const UploadedLumigraph uploaded(lumigraph);
    Paper2001 mode(uploaded);
    Framebuffer framebuffer;
    framebuffer.attach_color(kWidth_px, kHeight_px);
    glViewport(0, 0, kWidth_px, kHeight_px);
    glClear(GL_COLOR_BUFFER_BIT);
    mode.draw_passes(triangles, kBlendEye, {});
    const auto pixels = framebuffer.read_rgba_bottom_up(kWidth_px, kHeight_px);
    const ColorImage& photograph = lumigraph.views[0].photograph;
    for (int y = 0; y < kHeight_px; ++y) {
        for (int x = 0; x < kWidth_px; ++x) {
            const auto at = 4 * static_cast<std::size_t>(x + (kHeight_px - 1 - y) * kWidth_px);
            EXPECT_NEAR(pixels[at], photograph(x, y).r, 1) << x << ' ' << y;
            EXPECT_EQ(pixels[at + 3], 255) << x << ' ' << y;
        }
    }
}

}  // namespace
}  // namespace lumi
