#include "render/depth_layers/depth_layers.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "render/gl/headless_context.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

std::vector<float> texels_of(const DepthLayers& layers, GLenum format) {
    const TextureArray& texture = layers.texture();
    std::vector<float> texels(texture.bytes() / sizeof(float));
    texture.bind(0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, format, GL_FLOAT, texels.data());
    return texels;
}

void expect_same(const Lumigraph& lumigraph, const Eye& eye) {
    const UploadedLumigraph uploaded(lumigraph);
    DepthLayers by_open_gl(uploaded, 3, DepthLayers::DrawnBy::kOpenGl);
    DepthLayers by_cores(uploaded, 3, DepthLayers::DrawnBy::kCores);
    const std::vector<DepthViewSet> sets{{{0, 1, 2}, 0.6}, {{3, 1, 2}, 0.4}};
    for (const int samples : {1, 2}) {
        by_open_gl.draw({eye, 1.0, samples}, sets);
        by_cores.draw({eye, 1.0, samples}, sets);
        const std::vector<float> expected = texels_of(by_open_gl, GL_DEPTH_COMPONENT);
        const std::vector<float> texels = texels_of(by_cores, GL_RED);
        ASSERT_EQ(by_cores.texture().layers(), 3 * samples);
        ASSERT_EQ(texels.size(), expected.size());
        std::size_t unlike = 0;
        std::size_t known = 0;
        for (std::size_t i = 0; i < texels.size(); ++i) {
            unlike += std::abs(texels[i] - expected[i]) > 1e-4F ? 1U : 0U;
            known += expected[i] < 1.0F ? 1U : 0U;
        }
        EXPECT_GT(known, texels.size() / 4);
        // Along the sides of triangles that end there.
        EXPECT_LT(unlike, texels.size() / 200) << samples << " samples";
    }
}

TEST(DepthLayersGl, AreTheSameByOpenGlAndByTheCores) {
    const HeadlessContext context(GlApi::kCore);
    const Camera camera = pinhole_camera(97, 71, 80);
    expect_same(card_before_wall(), eye_at({0.3, 0.2, 0.2}, {0, 0, 4}, camera));
    expect_same(card_before_wall(), eye_at({0.4, 0.3, 2.6}, {0, 0, 4}, camera));
    expect_same(ball_in_sky(), eye_at({0.3, 0.2, 2.2}, {0, 0, 0.2}, camera));
}

}  // namespace
}  // namespace lumi
