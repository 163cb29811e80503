#include "meshing/depth/edge_aware_fill.h"

#include <gtest/gtest.h>

#include <random>

namespace lumi {
namespace {

constexpr int kWidth = 120;
constexpr int kHeight = 80;
constexpr float kOnePixel = 0.01F;

TEST(EdgeAwareFill, KeepsWhatIsKnown) {
    std::mt19937 random(11);
    DepthMap map{FloatImage(kWidth, kHeight), GrayImage(kWidth, kHeight)};
    ColorImage photograph(kWidth, kHeight);
    for (std::size_t i = 0; i < photograph.pixels().size(); ++i) {
        photograph.pixels()[i].g = static_cast<std::uint8_t>(random() % 256);
        map.inverse_depth.pixels()[i] = static_cast<float>(random() % 1000) / 1000.0F;
        map.confidence.pixels()[i] = random() % 4 == 0 ? 0 : 200;
    }
    const DepthMap before = map;
    edge_aware_fill(map, photograph, FloatImage(kWidth, kHeight, 0.5F), kOnePixel);
    EXPECT_EQ(map.confidence, before.confidence);
    for (std::size_t i = 0; i < photograph.pixels().size(); ++i) {
        if (before.confidence.pixels()[i] == 0) continue;
        ASSERT_EQ(map.inverse_depth.pixels()[i], before.inverse_depth.pixels()[i]) << i;
    }
}

TEST(EdgeAwareFill, ContinuesTheBackgroundBesideAnObject) {
    // Object (near, bright) in columns 60 on, wall (far, dark) left; 45 to 59 unknown, all wall.
    DepthMap map{FloatImage(kWidth, kHeight, 0.2F), GrayImage(kWidth, kHeight, 255)};
    ColorImage photograph(kWidth, kHeight, {60, 60, 60});
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 45; x < kWidth; ++x) {
            if (x < 60) {
                map.confidence(x, y) = 0;
                map.inverse_depth(x, y) = 7.0F;
            } else {
                map.inverse_depth(x, y) = 0.9F;
                photograph(x, y) = {200, 200, 200};
            }
        }
    }
    edge_aware_fill(map, photograph, FloatImage(kWidth, kHeight, 0.5F), kOnePixel);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 45; x < 60; ++x) {
            ASSERT_NEAR(map.inverse_depth(x, y), 0.2F, kOnePixel) << x << " " << y;
        }
    }
}

TEST(EdgeAwareFill, ClosesAHoleInASlantedPlane) {
    DepthMap map{FloatImage(kWidth, kHeight), GrayImage(kWidth, kHeight, 255)};
    const auto plane = [](int x, int y) { return 0.2F + 0.001F * static_cast<float>(x + y); };
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            map.inverse_depth(x, y) = plane(x, y);
            if (x >= 50 && x < 70 && y >= 30 && y < 50) map.confidence(x, y) = 0;
        }
    }
    edge_aware_fill(map, ColorImage(kWidth, kHeight), FloatImage(kWidth, kHeight), kOnePixel);
    for (int y = 30; y < 50; ++y) {
        for (int x = 50; x < 70; ++x) {
            ASSERT_NEAR(map.inverse_depth(x, y), plane(x, y), kOnePixel) << x << " " << y;
        }
    }
}

TEST(EdgeAwareFill, WithNothingKnownTakesTheFallback) {
    DepthMap map{FloatImage(kWidth, kHeight), GrayImage(kWidth, kHeight)};
    edge_aware_fill(map, ColorImage(kWidth, kHeight), FloatImage(kWidth, kHeight, 0.5F), kOnePixel);
    for (const float value : map.inverse_depth.pixels()) ASSERT_NEAR(value, 0.5F, 1e-6F);
}

}  // namespace
}  // namespace lumi
