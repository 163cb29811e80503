#include "meshing/filling/plane_slopes.h"

#include <gtest/gtest.h>

#include <utility>

namespace lumi {
namespace {

constexpr double kMostOffPlane = 0.01;

/// Inverse depth 1 + 0.002 x - 0.003 y up to column 60, and from there on what rises thrice as
/// steeply downwards; all known.
DepthMap two_planes() {
    DepthMap map{FloatImage(120, 80), GrayImage(120, 80, 255)};
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 120; ++x) {
            map.inverse_depth(x, y) = 1.0F + 0.002F * static_cast<float>(x) +
                                      (x < 60 ? -0.003F : 0.009F) * static_cast<float>(y);
        }
    }
    return map;
}

TEST(PlaneSlopes, AreThoseOfThePlanes) {
    const PlaneSlopes slopes = plane_slopes(two_planes(), kMostOffPlane);
    for (const int y : {0, 40, 79}) {
        for (const auto& [x, down] : {std::pair(0, -0.003F), std::pair(31, -0.003F),
                                      std::pair(88, 0.009F), std::pair(104, 0.009F)}) {
            const PlaneSlopes::Slope& slope = slopes.at(x, y);
            EXPECT_TRUE(slope.is_plane) << x << ' ' << y;
            EXPECT_NEAR(slope.per_pixel.x(), 0.002F, 1e-5F) << x << ' ' << y;
            EXPECT_NEAR(slope.per_pixel.y(), down, 1e-5F) << x << ' ' << y;
        }
    }
}

TEST(PlaneSlopes, AreNoneWhereTwoPlanesMeetOrPixelsLieOff) {
    DepthMap map = two_planes();
    EXPECT_FALSE(plane_slopes(map, kMostOffPlane).at(60, 76).is_plane);
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 60; ++x) {
            map.inverse_depth(x, y) +=
                ((x / 3 + y / 3) % 2 == 0 ? 1.5F : -1.5F) * static_cast<float>(kMostOffPlane);
        }
    }
    const PlaneSlopes slopes = plane_slopes(map, kMostOffPlane);
    EXPECT_FALSE(slopes.at(16, 40).is_plane);
    EXPECT_EQ(slopes.at(16, 40).per_pixel, Eigen::Vector2f::Zero());
    EXPECT_TRUE(plane_slopes(map, 2 * kMostOffPlane).at(16, 40).is_plane);
}

TEST(PlaneSlopes, AskKnownPixelsAloneAndAThirdOfAll) {
    DepthMap map = two_planes();
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 60; ++x) {
            if (y % 2 == 0) continue;  // Every other of those that are asked.
            map.confidence(x, y) = 0;
            map.inverse_depth(x, y) = 100.0F;
        }
    }
    const PlaneSlopes::Slope half = plane_slopes(map, kMostOffPlane).at(24, 40);
    EXPECT_TRUE(half.is_plane);
    EXPECT_NEAR(half.per_pixel.y(), -0.003F, 1e-5F);
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 60; ++x) {
            if (x % 2 == 0) map.confidence(x, y) = 0;
        }
    }
    EXPECT_FALSE(plane_slopes(map, kMostOffPlane).at(24, 40).is_plane) << "a quarter is known";
}

}  // namespace
}  // namespace lumi
