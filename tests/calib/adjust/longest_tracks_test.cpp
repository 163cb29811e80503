#include "calib/adjust/longest_tracks.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

using Indices = std::vector<std::size_t>;

const std::vector<std::vector<int>> kViewsOfTracks{{0, 1}, {1, 2}, {0, 1, 2}, {2, 3}, {0, 2}};

TEST(LongestTracks, AreAllWhereViewsHaveTooFew) {
    EXPECT_EQ(longest_tracks(kViewsOfTracks, 4, 10), (Indices{2, 0, 1, 3, 4}));
}

TEST(LongestTracks, AreThoseThatAnyViewStillWants) {
    EXPECT_EQ(longest_tracks(kViewsOfTracks, 4, 1), (Indices{2, 3}));
    EXPECT_EQ(longest_tracks(kViewsOfTracks, 4, 2), (Indices{2, 0, 1, 3}));
}

TEST(LongestTracks, AreNoneOfNone) { EXPECT_EQ(longest_tracks({}, 4, 1), Indices{}); }

}  // namespace
}  // namespace lumi
