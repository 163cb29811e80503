#include "render/depth_mesh/surface_end.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lumi {
namespace {

/// So far behind that it limits nothing.
constexpr float kFarBehind = -100.0F;

TEST(SurfaceEnd, OfOneSampleIsAtItsDepth) {
    EXPECT_FLOAT_EQ(inverse_depth_at_end(std::array{0.7F}, 0.1F), 0.7F);
}

TEST(SurfaceEnd, ContinuesAPlane) {
    for (const float slope : {-0.02F, 0.0F, 0.03F}) {
        for (const float beyond : {0.1F, 2.0F}) {
            const std::array plane{0.7F, 0.7F - slope, 0.7F - 2 * slope};
            EXPECT_NEAR(inverse_depth_at_end(plane, beyond), 0.7F + 0.5F * slope, 1e-6) << slope;
            const std::array two{plane[0], plane[1]};
            EXPECT_NEAR(inverse_depth_at_end(two, beyond), 0.7F + 0.5F * slope, 1e-6) << slope;
        }
    }
}

// Of a ball seen from afar, inverse depth is, but for a scale, the root of 1 - (distance from the
// middle)^2: near the outline that of the distance from there.
TEST(SurfaceEnd, IsAsDeepAsTheOutlineOfABall) {
    constexpr double kRadius_samples = 80.0;
    for (double outline = 0.05; outline < 0.95; outline += 0.1) {
        const auto inverse_depth = [&](double back) {
            const double from_middle = 1 - (outline + back) / kRadius_samples;
            return static_cast<float>(0.5 + 0.1 * std::sqrt(1 - from_middle * from_middle));
        };
        const std::array ball{inverse_depth(0), inverse_depth(1), inverse_depth(2)};
        EXPECT_NEAR(inverse_depth_at_end(ball, kFarBehind), 0.5, 0.001) << outline;
    }
}

TEST(SurfaceEnd, IsAtTheVertexOfAParabolaUnlessItIsWhatLiesBehind) {
    const std::array parabola{0.5F + 0.1F * std::sqrt(0.3F), 0.5F + 0.1F * std::sqrt(1.3F),
                              0.5F + 0.1F * std::sqrt(2.3F)};
    EXPECT_NEAR(inverse_depth_at_end(parabola, kFarBehind), 0.5F, 1e-4);
    EXPECT_NEAR(inverse_depth_at_end(parabola, 3.0F),
                parabola[0] + 0.5F * (parabola[0] - parabola[1]), 1e-5);
}

TEST(SurfaceEnd, GoesNoMoreThanHalfOfTheWayToWhatIsBeyond) {
    for (const float beyond : {0.4F, 0.9F}) {
        for (const float slope : {-1.0F, -0.3F, 0.3F, 1.0F}) {
            const float end = inverse_depth_at_end(std::array{0.6F, 0.6F - slope}, beyond);
            EXPECT_LE(std::abs(end - 0.6F), 0.5F * std::abs(beyond - 0.6F) + 1e-6F) << slope;
        }
    }
    EXPECT_EQ(inverse_depth_at_end(std::array{0.01F, 0.2F}, 0.6F), 0.0F);
}

TEST(SurfaceEnd, IsNoFartherThanSlopesTellWhateverThreeSamplesSay) {
    for (int one = -20; one <= 20; ++one) {
        for (int two = -40; two <= 40; ++two) {
            const float one_back = 0.01F * static_cast<float>(one);
            const std::array samples{1.0F, 1.0F + one_back, 1.0F + 0.01F * static_cast<float>(two)};
            ASSERT_LE(std::abs(inverse_depth_at_end(samples, kFarBehind) - 1.0F),
                      2.5F * std::abs(one_back) + 1e-6F)
                << one << " " << two;
        }
    }
}

}  // namespace
}  // namespace lumi
