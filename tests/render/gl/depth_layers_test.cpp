#include "render/depth_layers/depth_layers.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "render/gl/headless_context.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr int kLayers = 3;

/// Layer by layer, sample by sample.
std::vector<float> texels_of(const DepthLayers& layers, int samples) {
    const TextureArray& texture = layers.texture();
    std::vector<float> texels(texture.bytes() / sizeof(float));
    texture.bind(0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, layers.is_packed() ? GL_RGBA : GL_DEPTH_COMPONENT,
                  GL_FLOAT, texels.data());
    if (!layers.is_packed()) return texels;
    const std::size_t texels_a_sample = texels.size() / 4 / static_cast<std::size_t>(samples);
    std::vector<float> in_layers;
    for (std::size_t sample = 0; sample < static_cast<std::size_t>(samples); ++sample)
        for (std::size_t layer = 0; layer < kLayers; ++layer)
            for (std::size_t i = 0; i < texels_a_sample; ++i)
                in_layers.push_back(texels[4 * (sample * texels_a_sample + i) + layer]);
    return in_layers;
}

void expect_same(const Lumigraph& lumigraph, const Eye& eye) {
    const UploadedLumigraph uploaded(lumigraph);
    DepthLayers by_open_gl(uploaded, kLayers, DepthLayers::DrawnBy::kOpenGl);
    DepthLayers by_cores(uploaded, kLayers, DepthLayers::DrawnBy::kCores);
    const std::vector<DepthViewSet> sets{{{0, 1, 2}, 0.6}, {{3, 1, 2}, 0.4}};
    for (const int samples : {1, 2}) {
        by_open_gl.draw({eye, 1.0, samples}, sets);
        by_cores.draw({eye, 1.0, samples}, sets);
        const std::vector<float> expected = texels_of(by_open_gl, samples);
        const std::vector<float> texels = texels_of(by_cores, samples);
        ASSERT_EQ(by_open_gl.texture().layers(), kLayers * samples);
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
