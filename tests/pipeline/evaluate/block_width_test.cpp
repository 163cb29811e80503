#include "pipeline/evaluate/block_width.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

TEST(BlockWidth, LosesTheMostThatMayBeBetweenTheWidthsThatWereAsked) {
    EXPECT_DOUBLE_EQ(width_that_loses(0.1, {{1.25, 0.05}, {1.5, 0.15}, {2.0, 0.8}}), 1.375);
    EXPECT_DOUBLE_EQ(width_that_loses(0.1, {{1.25, 0.0}, {1.5, 0.1}, {2.0, 0.3}}), 1.5);
}

TEST(BlockWidth, GoesUpFromBlocksOfOnePixelWhichLoseNothing) {
    EXPECT_DOUBLE_EQ(width_that_loses(0.1, {{1.25, 0.2}, {1.5, 0.4}, {2.0, 0.8}}), 1.125);
}

TEST(BlockWidth, IsTheWidestWhereThatLosesNoMore) {
    EXPECT_DOUBLE_EQ(width_that_loses(0.1, {{1.25, -0.01}, {1.5, 0.02}, {2.0, 0.1}}), 2.0);
}

TEST(BlockWidth, EndsBeforeTheFirstThatLosesMoreThoughAWiderOneLosesLess) {
    EXPECT_LT(width_that_loses(0.1, {{1.25, 0.2}, {1.5, 0.0}, {2.0, 0.8}}), 1.25);
}

}  // namespace
}  // namespace lumi
