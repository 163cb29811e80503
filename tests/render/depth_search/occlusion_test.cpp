#include "render/depth_search/occlusion.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

TEST(Occlusion, OneOccludedViewGivesItsWeightToTheOthersAsInThePaper) {
    const double x = 0.5;
    const double y = 0.3;
    const double z = 0.2;
    const auto weights = redistributed({x, y, z}, {1, 1, 0});
    ASSERT_TRUE(weights.has_value());
    for (const auto& corrected :
         {*weights, redistributed_by_the_paper({x, y, z}, {true, true, false})}) {
        EXPECT_NEAR(corrected[0], x + z * x / (x + y), 1e-12);
        EXPECT_NEAR(corrected[1], y + z * y / (x + y), 1e-12);
        EXPECT_EQ(corrected[2], 0);
    }
}

TEST(Occlusion, TheOnlyViewThatSeesGetsAll) {
    const std::array<double, 3> third{0, 0, 1};
    EXPECT_EQ(redistributed({0.7, 0.2, 0.1}, {0, 0, 1}), third);
    EXPECT_EQ(redistributed_by_the_paper({0.7, 0.2, 0.1}, {false, false, true}), third);
}

// Opposite of a view, on the edge of the patch, its weight is 0; "the remaining view receives a
// weight of 1", so that the patch does not appear darker.
TEST(Occlusion, ByThePaperTheOnlyViewThatSeesGetsAllAlsoWhereItHadNoWeight) {
    EXPECT_EQ(redistributed_by_the_paper({0.5, 0.5, 0}, {false, false, true}),
              (std::array<double, 3>{0, 0, 1}));
    EXPECT_EQ(redistributed_by_the_paper({1, 0, 0}, {false, true, true}),
              (std::array<double, 3>{0, 0.5, 0.5}));
}

TEST(Occlusion, NothingIsLeftWhenNoneSees) {
    EXPECT_FALSE(redistributed({0.5, 0.3, 0.2}, {0, 0, 0}).has_value());
    EXPECT_FALSE(redistributed({1, 0, 0}, {0, 1, 1}).has_value());
    EXPECT_EQ(redistributed_by_the_paper({0.5, 0.3, 0.2}, {false, false, false}),
              (std::array<double, 3>{}));
}

TEST(Occlusion, WeightsStayWhenAllSee) {
    const auto weights = redistributed({0.5, 0.3, 0.2}, {1, 1, 1});
    ASSERT_TRUE(weights.has_value());
    EXPECT_NEAR((*weights)[0], 0.5, 1e-15);
    EXPECT_NEAR((*weights)[1], 0.3, 1e-15);
}

TEST(Occlusion, TheOccludedShareIsWhatTheUnseenWeigh) {
    EXPECT_NEAR(occluded_share({0.5, 0.3, 0.2}, {1, 1, 1}), 0, 1e-15);
    EXPECT_NEAR(occluded_share({0.5, 0.3, 0.2}, {1, 0, 0.5}), 0.4, 1e-15);
    EXPECT_EQ(occluded_share({0.5, 0.3, 0.2}, {0, 0, 0}), 1);
}

TEST(Occlusion, VisibilityFallsBetweenOneAndTwoTolerances) {
    EXPECT_EQ(visibility_of(0.0, 1.5), 1);
    EXPECT_EQ(visibility_of(1.5, 1.5), 1);
    EXPECT_DOUBLE_EQ(visibility_of(2.25, 1.5), 0.5);
    EXPECT_EQ(visibility_of(3.0, 1.5), 0);
}

TEST(Occlusion, AViewCountsNothingOutsideOfItsPhotograph) {
    EXPECT_EQ(border_fade(-0.1), 0);
    EXPECT_EQ(border_fade(0), 0);
    EXPECT_GT(border_fade(0.5), 0);
    EXPECT_EQ(border_fade(20), 1);
}

}  // namespace
}  // namespace lumi
