#include "render/subdivision/edge_error.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

/// Looked up in one photograph, `place_px` along its row.
BlendVertex looked_up_at(float place_px, float confidence) {
    BlendVertex vertex;
    vertex.view_pixels[0] = {place_px, 20};
    vertex.weights = {1, 0, 0};
    vertex.confidence = confidence;
    return vertex;
}

TEST(EdgeError, IsHowFarAMiddleIsFromHalfway) {
    EXPECT_DOUBLE_EQ(edge_error_px(looked_up_at(10, 1), looked_up_at(20, 1), looked_up_at(15, 1)),
                     0.0);
    EXPECT_DOUBLE_EQ(edge_error_px(looked_up_at(10, 1), looked_up_at(20, 1), looked_up_at(18, 1)),
                     3.0);
}

TEST(EdgeError, IsTwiceTheErrorOfAWeight) {
    BlendVertex middle = looked_up_at(15, 1);
    middle.weights = {0.75F, 0.25F, 0};
    EXPECT_DOUBLE_EQ(
        edge_error_px(looked_up_at(10, 1), looked_up_at(20, 1), middle, {.weight_error_px = 1.0}),
        0.5);
    EXPECT_DOUBLE_EQ(
        edge_error_px(looked_up_at(10, 1), looked_up_at(20, 1), middle, {.weight_error_px = 3.0}),
        1.5);
}

TEST(EdgeError, AGuessMayBeFourTimesAsFarOff) {
    const BlendVertex a = looked_up_at(10, 1);
    const BlendVertex b = looked_up_at(20, 1);
    const double seen = edge_error_px(a, b, looked_up_at(18, kSeenByOne));
    EXPECT_DOUBLE_EQ(edge_error_px(a, b, looked_up_at(18, 0.25F)), seen / 4);
}

TEST(EdgeError, EdgesAreLeftFourTimesAsLongAmongGuessesButNotWhereWhatWasSeenEnds) {
    const BlendVertex seen = looked_up_at(10, kSeenByOne);
    const BlendVertex guess = looked_up_at(10, 0.25F);
    const BlendVertex lost = looked_up_at(10, 0);
    EXPECT_DOUBLE_EQ(edge_looseness(guess, lost, guess), 4.0);
    EXPECT_DOUBLE_EQ(edge_looseness(guess, guess, guess, {.guess_ratio = 1.0}), 1.0);
    EXPECT_DOUBLE_EQ(edge_looseness(seen, guess, guess), 1.0);
    EXPECT_DOUBLE_EQ(edge_looseness(guess, seen, guess), 1.0);
    EXPECT_DOUBLE_EQ(edge_looseness(guess, guess, seen), 1.0);
}

TEST(EdgeError, CountsWhereThePhotographsLoseTheSceneHalfway) {
    const BlendVertex seen = looked_up_at(10, 1);
    const BlendVertex lost = looked_up_at(10, 0);
    EXPECT_DOUBLE_EQ(edge_error_px(lost, lost, seen), 8.0);
    EXPECT_DOUBLE_EQ(edge_error_px(lost, seen, seen), 4.0);
    EXPECT_DOUBLE_EQ(edge_error_px(lost, lost, lost), 0.0);
}

TEST(EdgeError, ALongEdgeIsSplitUntilItsErrorIsAllowed) {
    EXPECT_DOUBLE_EQ(greatest_relaxation(2.0, 16.0), 2.0);
}

TEST(EdgeError, AnEdgeThatIsTooShortIsNotSplitForAnyError) {
    EXPECT_LT(greatest_relaxation(1e6, 0.9), 1.0);
}

TEST(EdgeError, AShortEdgeIsGivenUpBeforeALongOneOfTheSameError) {
    EXPECT_LT(greatest_relaxation(8.0, 1.5), greatest_relaxation(8.0, 3.0));
    EXPECT_LT(greatest_relaxation(8.0, 3.0), greatest_relaxation(64.0, 3.0));
}

}  // namespace
}  // namespace lumi
