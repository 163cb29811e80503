#include "meshing/surface/gradual_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace lumi {
namespace {

using Candidates = std::vector<std::size_t>;

std::map<Candidates, double> shares_of(const std::vector<double>& costs, std::size_t size = 3) {
    std::map<Candidates, double> shares;
    for (const GradualChoice& choice : gradual_choices(costs, size))
        shares[choice.chosen] += choice.share;
    return shares;
}

TEST(GradualChoice, IsOfTheLeastCostWhereNothingElseIsNear) {
    EXPECT_EQ(shares_of({5, 1, 4, 2, 3}), (std::map<Candidates, double>{{{1, 3, 4}, 1.0}}));
}

TEST(GradualChoice, IsHalfAndHalfWhereTwoCostTheSame) {
    const auto shares = shares_of({1, 3, 2, 3});
    ASSERT_EQ(shares.size(), 2U);
    EXPECT_NEAR(shares.at({0, 1, 2}), 0.5, 1e-12);
    EXPECT_NEAR(shares.at({0, 2, 3}), 0.5, 1e-12);
}

TEST(GradualChoice, IsOfAllWhereThereAreNoMore) {
    EXPECT_EQ(shares_of({2, 1}), (std::map<Candidates, double>{{{0, 1}, 1.0}}));
    EXPECT_EQ(shares_of({1, 1, 1}), (std::map<Candidates, double>{{{0, 1, 2}, 1.0}}));
}

TEST(GradualChoice, IsOfEightAtMostOfManyThatCostTheSame) {
    double sum = 0;
    for (const GradualChoice& choice : gradual_choices(std::vector<double>(40, 1.0), 3)) {
        EXPECT_LT(choice.chosen.back(), 8U);
        EXPECT_NEAR(choice.share, 1.0 / 56, 1e-12);
        sum += choice.share;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(GradualChoice, HardlyChangesWhereSeveralCostTheSame) {
    for (const std::size_t count : {4U, 5U, 6U, 8U}) {
        const std::vector<double> same(count, 1.0);
        for (std::size_t dearer = 0; dearer < count; ++dearer) {
            std::vector<double> costs = same;
            costs[dearer] += 1e-6;
            const auto shares = shares_of(costs);
            for (const auto& [chosen, share] : shares_of(same))
                EXPECT_NEAR(shares.at(chosen), share, 1e-3) << count;
        }
    }
}

TEST(GradualChoice, ChangesGraduallyWithTheCostsOfSeven) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> cost(1.0, 1.3);
    constexpr int kSteps = 8000;
    for (int path = 0; path < 40; ++path) {
        std::vector<double> from;
        std::vector<double> to;
        for (int i = 0; i < 7; ++i) {
            from.push_back(cost(random));
            to.push_back(cost(random));
        }
        std::map<Candidates, double> before;
        for (int step = 0; step <= kSteps; ++step) {
            std::vector<double> costs;
            for (std::size_t i = 0; i < from.size(); ++i)
                costs.push_back(from[i] + (to[i] - from[i]) * step / kSteps);
            const auto shares = shares_of(costs);
            double sum = 0;
            double change = 0;
            for (const auto& [chosen, share] : shares) {
                sum += share;
                change += std::abs(share - (before.contains(chosen) ? before[chosen] : 0.0));
            }
            EXPECT_NEAR(sum, 1, 1e-12);
            // A step changes costs by at most 4e-5, a thousandth of the 0.04 that matter.
            if (step > 0) {
                EXPECT_LT(change, 0.02) << path << ' ' << step;
            }
            before = shares;
        }
    }
}

}  // namespace
}  // namespace lumi
