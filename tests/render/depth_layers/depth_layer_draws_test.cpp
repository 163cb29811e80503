#include "render/depth_layers/depth_layer_draws.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

/// Three views of 10 + 4 + 1, of 7, and of no triangles.
const std::vector<DepthKindBegins> kMeshes{{0, 30, 42, 45}, {0, 21, 21, 21}, {0, 0, 0, 0}};

TEST(DepthLayerDraws, EachKindOfAViewIsDrawnIntoItsLayer) {
    const auto draws = depth_layer_draws({{{0, 1}, 1.0}}, 3, 100, kMeshes);
    ASSERT_EQ(draws.size(), 4U);
    std::size_t indices = 0;
    for (const DepthLayerDraw& draw : draws) {
        EXPECT_EQ(draw.layer, draw.view_index);
        EXPECT_EQ(draw.strip_begin_px, 0);
        EXPECT_EQ(draw.strip_end_px, 100);
        indices += draw.index_count;
    }
    EXPECT_EQ(indices, 45U + 21U);
}

TEST(DepthLayerDraws, AViewThatTwoSetsHaveIsDrawnOnceForBoth) {
    const auto draws = depth_layer_draws({{{0, 1}, 0.5}, {{0, 2}, 0.5}}, 2, 100, kMeshes);
    ASSERT_EQ(draws.size(), 4U) << "three kinds of view 0, one of view 1";
    for (const DepthLayerDraw& draw : draws) {
        EXPECT_NE(draw.view_index, 2) << "it has no triangles";
        EXPECT_EQ(draw.strip_begin_px, 0);
        EXPECT_EQ(draw.strip_end_px, draw.view_index == 0 ? 100 : 50);
    }
}

}  // namespace
}  // namespace lumi
