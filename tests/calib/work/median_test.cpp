#include "calib/work/median.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

TEST(Median, IsTheUpperOfTwoInTheMiddleAndTheHalfQuantileTheLower) {
    const std::vector<double> values{4, 1, 3, 2};
    EXPECT_EQ(median_of(values), 3);
    EXPECT_EQ(quantile_of(values, 0.5), 2);
    EXPECT_EQ(median_of(std::vector<double>{5, 1, 3}), 3);
    EXPECT_EQ(quantile_of(std::vector<double>{5, 1, 3}, 0.5), 3);
}

TEST(Median, QuantilesReachFromTheLeastToTheMost) {
    const std::vector<float> values{0.5F, 0.1F, 0.9F};
    EXPECT_EQ(quantile_of(values, 0.0), 0.1F);
    EXPECT_EQ(quantile_of(values, 0.99), 0.5F);
    EXPECT_EQ(quantile_of(values, 1.0), 0.9F);
    EXPECT_EQ(value_of_rank(values, 1), 0.5F);
}

TEST(Median, OfNothingIsWhatIsAskedFor) {
    EXPECT_EQ(median_of(std::vector<double>{}), 0.0);
    EXPECT_EQ(median_of(std::vector<double>{}, 7), 7.0);
    EXPECT_EQ(quantile_of(std::vector<int>{}, 0.5, -1), -1);
}

}  // namespace
}  // namespace lumi
