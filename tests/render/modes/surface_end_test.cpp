#include "render/modes/surface_end.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lumi {
namespace {

/// So far behind that it limits nothing.
constexpr std::array kFarBehind{-100.0F};

TEST(SurfaceEnd, OfOneSampleIsHalfwayAtItsDepth) {
    const SurfaceEnds ends = surface_ends(std::array{0.7F}, std::array{0.1F});
    EXPECT_FLOAT_EQ(ends.share, 0.5F);
    EXPECT_FLOAT_EQ(ends.nearer_inverse_depth, 0.7F);
    EXPECT_FLOAT_EQ(ends.farther_inverse_depth, 0.1F);
}

TEST(SurfaceEnd, ContinuesPlanesOnBothSides) {
    for (const float slope : {-0.02F, 0.0F, 0.03F}) {
        const std::array nearer{0.7F, 0.7F - slope, 0.7F - 2 * slope};
        const std::array farther{0.2F, 0.2F + slope};
        const SurfaceEnds ends = surface_ends(nearer, farther);
        EXPECT_FLOAT_EQ(ends.share, 0.5F) << slope;
        EXPECT_NEAR(ends.nearer_inverse_depth, 0.7F + 0.5F * slope, 1e-6) << slope;
        EXPECT_NEAR(ends.farther_inverse_depth, 0.2F - 0.5F * slope, 1e-6) << slope;
    }
}

// Of a ball seen from afar, inverse depth is, but for a scale, the root of 1 - (distance from the
// middle)^2: near the outline that of the distance from there.
TEST(SurfaceEnd, IsAtTheOutlineOfABall) {
    constexpr double kRadius_samples = 80.0;
    for (double outline = 0.05; outline < 1.0; outline += 0.1) {
        const auto inverse_depth = [&](double back) {
            const double from_middle = 1 - (outline + back) / kRadius_samples;
            return static_cast<float>(0.5 + 0.1 * std::sqrt(1 - from_middle * from_middle));
        };
        const std::array ball{inverse_depth(0), inverse_depth(1), inverse_depth(2)};
        const SurfaceEnds ends = surface_ends(ball, kFarBehind);
        EXPECT_NEAR(ends.share, outline, 0.07);
        EXPECT_NEAR(ends.nearer_inverse_depth, 0.5, 0.001);
    }
}

TEST(SurfaceEnd, IsExactForAParabola) {
    const std::array nearer{0.5F + 0.1F * std::sqrt(0.3F), 0.5F + 0.1F * std::sqrt(1.3F),
                            0.5F + 0.1F * std::sqrt(2.3F)};
    const SurfaceEnds ends = surface_ends(nearer, std::array{0.1F, 0.11F});
    EXPECT_NEAR(ends.share, 0.3F, 1e-3);
    EXPECT_NEAR(ends.nearer_inverse_depth, 0.5F, 1e-4);
    EXPECT_NEAR(ends.farther_inverse_depth, 0.1F - 0.7F * 0.01F, 1e-5);
}

TEST(SurfaceEnd, GoesNoMoreThanHalfOfTheWayToTheOther) {
    for (const float slope : {-1.0F, -0.3F, 0.3F, 1.0F}) {
        const SurfaceEnds ends =
            surface_ends(std::array{0.6F, 0.6F - slope}, std::array{0.4F, 0.4F - slope});
        EXPECT_LE(std::abs(ends.nearer_inverse_depth - 0.6F), 0.1F + 1e-6F) << slope;
        EXPECT_LE(std::abs(ends.farther_inverse_depth - 0.4F), 0.1F + 1e-6F) << slope;
    }
    EXPECT_EQ(surface_ends(std::array{0.6F}, std::array{0.01F, 0.2F}).farther_inverse_depth, 0.0F);
}

TEST(SurfaceEnd, IsBeforeTheNextSampleWhateverThreeSamplesSay) {
    for (int one = -20; one <= 20; ++one) {
        for (int two = -40; two <= 40; ++two) {
            const float one_back = 0.01F * static_cast<float>(one);
            const std::array nearer{1.0F, 1.0F + one_back, 1.0F + 0.01F * static_cast<float>(two)};
            const SurfaceEnds ends = surface_ends(nearer, kFarBehind);
            ASSERT_GE(ends.share, 0.0F) << one << " " << two;
            ASSERT_LE(ends.share, 1.0F) << one << " " << two;
            ASSERT_LE(std::abs(ends.nearer_inverse_depth - 1.0F), 2.5F * std::abs(one_back) + 1e-6F)
                << one << " " << two;
        }
    }
}

}  // namespace
}  // namespace lumi
