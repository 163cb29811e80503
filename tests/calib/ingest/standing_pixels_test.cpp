#include "calib/ingest/standing_pixels.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

ColorImage grey(std::initializer_list<int> levels) {
    ColorImage picture(static_cast<int>(levels.size()), 1);
    int x = 0;
    for (const int level : levels) {
        const auto value = static_cast<std::uint8_t>(level);
        picture(x++, 0) = {value, value, value};
    }
    return picture;
}

TEST(StandingPixels, SpreadIsTheStandardDeviationOverPhotographs) {
    StandingPixels standing(3, 1);
    standing.add(grey({10, 50, 200}));
    standing.add(grey({10, 70, 200}));
    EXPECT_EQ(standing.photographs(), 2);
    EXPECT_NEAR(standing.spread(0, 0), 0.0, 1e-3);
    EXPECT_NEAR(standing.spread(1, 0), 10.0, 1e-3);
    EXPECT_NEAR(standing.spread(2, 0), 0.0, 1e-3);
}

TEST(StandingPixels, TheMeanIsThatOfLuma) {
    StandingPixels standing(2, 1);
    for (const int level : {10, 20, 60}) standing.add(grey({level, 7}));
    EXPECT_DOUBLE_EQ(standing.mean(0, 0), 30.0);
    EXPECT_DOUBLE_EQ(standing.mean(1, 0), 7.0);
}

TEST(StandingPixels, TheMeanGradientIsSigned) {
    StandingPixels standing(3, 1);
    standing.add(grey({0, 50, 100}));
    standing.add(grey({100, 50, 0}));
    EXPECT_NEAR(standing.edge(1, 0).mean_gradient, 0.0, 1e-3);
    standing.add(grey({0, 50, 120}));
    EXPECT_NEAR(standing.edge(1, 0).mean_gradient, (50.0 - 50.0 + 60.0) / 3, 1e-3);
}

TEST(StandingPixels, SlopesAreCountedByTheirDirection) {
    StandingPixels standing(3, 1);
    standing.add(grey({0, 50, 100}));
    standing.add(grey({10, 20, 30}));
    standing.add(grey({100, 50, 0}));
    standing.add(grey({50, 50, 51}));
    EXPECT_NEAR(standing.edge(1, 0).same_slope_share, 0.5, 1e-9);
}

/// Red and green of equal luma meet.
TEST(StandingPixels, AnEdgeBetweenColoursOfOneLumaIsOneInAnyColour) {
    StandingPixels standing(3, 1);
    ColorImage picture(3, 1);
    picture(0, 0) = picture(1, 0) = {40, 100, 60};
    picture(2, 0) = {208, 50, 60};
    for (int i = 0; i < 3; ++i) standing.add(picture);
    EXPECT_NEAR(standing.edge(1, 0).mean_gradient, 0.0, 0.5);
    EXPECT_DOUBLE_EQ(standing.edge_in_any_color(1, 0).mean_gradient, 0.5 * (208 - 40));
    EXPECT_DOUBLE_EQ(standing.edge_in_any_color(1, 0).same_slope_share, 1.0);
}

TEST(StandingPixels, EdgesOfGreyPhotographsAreTheSameInAnyColour) {
    StandingPixels standing(4, 1);
    standing.add(grey({0, 50, 90, 100}));
    standing.add(grey({30, 20, 10, 60}));
    for (int x = 0; x < 4; ++x)
        EXPECT_EQ(standing.edge_in_any_color(x, 0), standing.edge(x, 0)) << x;
}

}  // namespace
}  // namespace lumi
