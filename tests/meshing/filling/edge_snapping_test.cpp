#include "meshing/filling/edge_snapping.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

constexpr float kPixelOfEdge = 0.01F;

/// A bright board over columns 40 on, whose depth begins `fat` columns too early.
struct FatEdge {
    DepthMap map{FloatImage(80, 60, 0.2F), GrayImage(80, 60, 255)};
    ColorImage photograph{80, 60, {60, 60, 60}};
    explicit FatEdge(int fat) {
        for (int y = 0; y < 60; ++y) {
            for (int x = 40 - fat; x < 80; ++x) {
                map.inverse_depth(x, y) = 0.6F;
                if (x >= 40) photograph(x, y) = {180, 170, 160};
            }
        }
    }
};

TEST(EdgeSnapping, MovesAFatEdgeToThePhotographs) {
    FatEdge edge(3);
    snap_edges(edge.map, edge.photograph, kPixelOfEdge);
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 80; ++x) {
            ASSERT_EQ(edge.map.inverse_depth(x, y), x < 40 ? 0.2F : 0.6F) << x << " " << y;
        }
    }
}

TEST(EdgeSnapping, LeavesAnEdgeThatThePhotographDoesNotShow) {
    FatEdge edge(3);
    edge.photograph = ColorImage(80, 60, {90, 90, 90});
    const DepthMap before = edge.map;
    snap_edges(edge.map, edge.photograph, kPixelOfEdge);
    for (int y = 8; y < 52; ++y) {
        for (int x = 0; x < 80; ++x) {
            ASSERT_EQ(edge.map.inverse_depth(x, y), before.inverse_depth(x, y)) << x << " " << y;
        }
    }
}

TEST(EdgeSnapping, LeavesWhatIsToBeKept) {
    FatEdge edge(3);
    GrayImage kept(80, 60);
    for (int x = 0; x < 80; ++x) kept(x, 30) = 255;
    const DepthMap before = edge.map;
    snap_edges(edge.map, edge.photograph, kPixelOfEdge, kept);
    for (int x = 0; x < 80; ++x) {
        ASSERT_EQ(edge.map.inverse_depth(x, 30), before.inverse_depth(x, 30)) << x;
        ASSERT_EQ(edge.map.inverse_depth(x, 29), x < 40 ? 0.2F : 0.6F) << x;
    }
}

TEST(EdgeSnapping, WithoutAPixelOfDisparityThereIsNoEdge) {
    FatEdge edge(3);
    const DepthMap before = edge.map;
    snap_edges(edge.map, edge.photograph, 0.0);
    EXPECT_EQ(edge.map.inverse_depth, before.inverse_depth);
}

TEST(EdgeSnapping, KeepsAThinPole) {
    DepthMap map{FloatImage(80, 60, 0.2F), GrayImage(80, 60, 255)};
    ColorImage photograph(80, 60, {60, 60, 60});
    for (int y = 0; y < 60; ++y) {
        for (int x = 40; x < 43; ++x) {
            map.inverse_depth(x, y) = 0.6F;
            photograph(x, y) = {200, 40, 40};
        }
    }
    const DepthMap before = map;
    snap_edges(map, photograph, kPixelOfEdge);
    EXPECT_EQ(map.inverse_depth, before.inverse_depth);
}

TEST(EdgeSnapping, LeavesASlopeAlone) {
    DepthMap map{FloatImage(80, 60), GrayImage(80, 60, 255)};
    ColorImage photograph(80, 60);
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 80; ++x) {
            map.inverse_depth(x, y) = 0.2F + 0.4F * kPixelOfEdge * static_cast<float>(x);
            photograph(x, y).r = static_cast<std::uint8_t>((x / 3 + y / 3) % 2 * 200);
        }
    }
    const DepthMap before = map;
    snap_edges(map, photograph, kPixelOfEdge);
    EXPECT_EQ(map.inverse_depth, before.inverse_depth);
}

}  // namespace
}  // namespace lumi
