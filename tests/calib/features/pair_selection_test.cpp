#include "calib/features/pair_selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace lumi {
namespace {

/// Photographs in groups: those of one group show the same features.
std::vector<Features> photographs_in_groups(int groups, int photographs_per_group) {
    std::mt19937 random(4);
    std::vector<Features> photographs;
    for (int group = 0; group < groups; ++group) {
        Features features;
        for (int feature = 0; feature < 20; ++feature) {
            Descriptor descriptor{};
            // Few large values: such descriptors are far from one another.
            for (int count = 0; count < 8; ++count) {
                descriptor[random() % kDescriptorSize] = 181;
            }
            features.descriptors.push_back(descriptor);
            features.keypoints.emplace_back();
        }
        for (int count = 0; count < photographs_per_group; ++count) {
            photographs.push_back(features);
        }
    }
    return photographs;
}

TEST(PairSelection, ComparesAllWithAllInASmallSet) {
    SilentProgress progress;
    const auto pairs = select_pairs(photographs_in_groups(4, 1), {}, 2, progress);
    EXPECT_EQ(pairs,
              (std::vector<std::pair<int, int>>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
}

TEST(PairSelection, KeepsWhatLooksAlikeAndWhatFollowsInALargeSet) {
    SilentProgress progress;
    PairSelectionOptions options;
    options.exhaustive_up_to = 10;
    options.neighbours = 1;
    const auto pairs = select_pairs(photographs_in_groups(4, 5), options, 2, progress);
    std::vector<std::pair<int, int>> expected;
    for (int first = 0; first < 20; ++first) {
        for (int second = first + 1; second < 20; ++second) {
            if (first / 5 == second / 5 || second == first + 1) {
                expected.emplace_back(first, second);
            }
        }
    }
    EXPECT_EQ(pairs, expected);
}

TEST(PairSelection, IsTheSameForAnyNumberOfThreads) {
    SilentProgress progress;
    PairSelectionOptions options;
    options.exhaustive_up_to = 2;
    const auto photographs = photographs_in_groups(5, 3);
    EXPECT_EQ(select_pairs(photographs, options, 1, progress),
              select_pairs(photographs, options, 4, progress));
}

}  // namespace
}  // namespace lumi
