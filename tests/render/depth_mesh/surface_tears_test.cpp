#include "render/depth_mesh/surface_tears.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lumi {
namespace {

constexpr int kSize = 12;
/// Pixels of disparity, for each pixel of pitch, are inverse depths.
constexpr DisparityPerPitch kInPixels{1.0, 1.0};

template <class Depth>
FloatImage depth_map(const Depth& depth_at) {
    FloatImage map(kSize, kSize);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) map(x, y) = depth_at(x, y);
    return map;
}

TEST(SurfaceTears, StepsOfTwoPixelsMayBeNoise) {
    EXPECT_FALSE(tears({0, 0, 1.9F, 1.9F}, 1.0));
    EXPECT_TRUE(tears({0, 0, 2.1F, 2.1F}, 1.0));
    EXPECT_FALSE(tears({0, 1.9F, 0, 1.9F}, 1.0));
    EXPECT_FALSE(tears({0, 0, 19.0F, 19.0F}, 0.1));
    EXPECT_DOUBLE_EQ(gentle_step(0.1), 20.0);
}

TEST(SurfaceTears, ASlopeThatGoesOnOnOneSideIsASurface) {
    EXPECT_FALSE(tears({0, 3, 6, 9}, 1.0));
    EXPECT_FALSE(tears({0, 3, 6, 6}, 1.0));
    EXPECT_FALSE(tears({6, 6, 3, 0}, 1.0));
}

TEST(SurfaceTears, NoSurfaceIsSteeperThanWhatTheNextViewCouldSee) {
    EXPECT_TRUE(tears({0, 5, 10, 15}, 1.0));
}

TEST(SurfaceTears, WhatIsTwoSamplesWideIsOneSurface) {
    EXPECT_FALSE(tears({0, 9, 9, 0}, 1.0));
    EXPECT_TRUE(tears({0, 0, 9, 9}, 1.0));
}

TEST(SurfaceTears, EndsOfTheMapGoOnAsTheyAre) {
    const GrayImage torn =
        torn_squares(depth_map([](int x, int) { return x == 0 ? 3.0F : 0.0F; }), kInPixels);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) EXPECT_EQ(torn(x, y), x == 0 ? 1 : 0) << x << ' ' << y;
}

TEST(SurfaceTears, SquaresTearAroundAThingAndNowhereElse) {
    const auto is_thing = [](int x, int y) { return x >= 4 && x < 8 && y >= 3 && y < 9; };
    const GrayImage torn =
        torn_squares(depth_map([&](int x, int y) {
                         return is_thing(x, y) ? 9.0F : 0.1F * static_cast<float>(x);
                     }),
                     kInPixels);
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const int right = std::min(x + 1, kSize - 1);
            const int below = std::min(y + 1, kSize - 1);
            const int of_thing =
                is_thing(x, y) + is_thing(right, y) + is_thing(x, below) + is_thing(right, below);
            EXPECT_EQ(torn(x, y), of_thing % 4 != 0 ? 1 : 0) << x << ' ' << y;
        }
    }
}

TEST(SurfaceTears, DisparityPerPitchIsThatOfTheMapsSamples) {
    const DepthMap depth{FloatImage(40, 20), GrayImage(40, 20)};
    const Camera camera{160, 60, LensModel::kPinhole, {100, 100, 80, 30}};
    const DisparityPerPitch disparity = disparity_per_pitch(depth, camera, 8.0);
    EXPECT_DOUBLE_EQ(disparity.along_row, 2.0);
    EXPECT_DOUBLE_EQ(disparity.along_column, 8.0 / 3);
}

}  // namespace
}  // namespace lumi
