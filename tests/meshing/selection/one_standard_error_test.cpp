#include "meshing/selection/one_standard_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lumi {
namespace {

TEST(OneStandardError, IsThatOfDifferencesPlaceByPlace) {
    const Excess excess = excess_over({11, 22, 36}, {10, 20, 30});
    EXPECT_DOUBLE_EQ(excess.mean, 3);
    // Differences 1, 2, 6: a variance of 7, over three places.
    EXPECT_DOUBLE_EQ(excess.standard_error, std::sqrt(7.0 / 3));
}

TEST(OneStandardError, OfASinglePlaceIsNone) {
    EXPECT_DOUBLE_EQ(excess_over({2}, {1}).standard_error, 0);
}

TEST(OneStandardError, TakesTheSimplestThatCannotBeToldFromTheBest) {
    const std::vector<double> best{10, 20, 30};
    const std::vector<double> within{11, 19, 31};
    const std::vector<double> beyond{11, 21, 31.5};
    EXPECT_EQ(simplest_as_good({best, within, beyond}), 1U);
    EXPECT_EQ(simplest_as_good({best, beyond, within}), 2U);
    EXPECT_EQ(simplest_as_good({best, beyond}), 0U);
    EXPECT_EQ(simplest_as_good({beyond, best, beyond}), 1U);
    EXPECT_EQ(simplest_as_good({best, best}), 1U);
    EXPECT_EQ(simplest_as_good({beyond}), 0U);
}

}  // namespace
}  // namespace lumi
