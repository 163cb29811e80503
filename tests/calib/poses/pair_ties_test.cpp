#include "calib/poses/pair_ties.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

namespace lumi {
namespace {

TEST(PairTies, AChainIsAsFirmAsItsWeakestPair) {
    const PairTies ties(5, {{0, 1, 500}, {1, 2, 300}, {0, 2, 40}, {2, 3, 90}});
    EXPECT_EQ(ties.between(0, 1), 500U);
    EXPECT_EQ(ties.between(2, 0), 300U) << "by way of 1";
    EXPECT_EQ(ties.between(0, 3), 90U);
    EXPECT_EQ(ties.between(0, 4), 0U) << "nothing leads there";
}

/// All chains tried, by Floyd and Warshall's scheme.
TEST(PairTies, AreThoseOfTheWidestOfAllChains) {
    constexpr std::size_t kViews = 9;
    std::mt19937 random(3);
    for (int trial = 0; trial < 20; ++trial) {
        std::array<std::array<std::size_t, kViews>, kViews> widest{};
        for (std::size_t view = 0; view < kViews; ++view)
            widest[view][view] = std::numeric_limits<std::size_t>::max();
        std::vector<PairTie> pairs;
        for (std::size_t a = 0; a < kViews; ++a) {
            for (std::size_t b = a + 1; b < kViews; ++b) {
                if (random() % 3 != 0) continue;
                const std::size_t matches = 30 + random() % 500;
                pairs.push_back({static_cast<int>(a), static_cast<int>(b), matches});
                widest[a][b] = widest[b][a] = matches;
            }
        }
        for (std::size_t by = 0; by < kViews; ++by)
            for (std::size_t a = 0; a < kViews; ++a)
                for (std::size_t b = 0; b < kViews; ++b)
                    widest[a][b] = std::max(widest[a][b], std::min(widest[a][by], widest[by][b]));
        const PairTies ties(kViews, pairs);
        for (std::size_t a = 0; a < kViews; ++a)
            for (std::size_t b = 0; b < kViews; ++b)
                EXPECT_EQ(ties.between(static_cast<int>(a), static_cast<int>(b)), widest[a][b]);
    }
}

}  // namespace
}  // namespace lumi
