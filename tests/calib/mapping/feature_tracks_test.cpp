#include "calib/mapping/feature_tracks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lumi {
namespace {

using testing::ElementsAre;

VerifiedPair pair_of(int first, int second, std::vector<FeatureMatch> inliers) {
    return {first, second, PairConfiguration::kUncalibrated, std::move(inliers)};
}

TEST(FeatureTracks, JoinWhatIsMatchedDirectlyOrThroughOthers) {
    const auto tracks = join_tracks(
        {2, 2, 2, 2}, {pair_of(0, 1, {{0, 1}}), pair_of(1, 2, {{1, 0}}), pair_of(0, 3, {{1, 1}})});
    EXPECT_THAT(tracks,
                ElementsAre(FeatureTrack{{0, 0}, {1, 1}, {2, 0}}, FeatureTrack{{0, 1}, {3, 1}}));
}

TEST(FeatureTracks, NeverHoldTwoFeaturesOfOnePhotograph) {
    // 0:0 - 1:0 - 2:0 and 2:0 - 0:1 would put both features of photograph 0 into one track.
    const auto tracks = join_tracks(
        {2, 1, 1}, {pair_of(0, 1, {{0, 0}}), pair_of(1, 2, {{0, 0}}), pair_of(0, 2, {{1, 0}})});
    EXPECT_THAT(tracks, ElementsAre(FeatureTrack{{0, 0}, {1, 0}, {2, 0}}));
}

TEST(FeatureTracks, BelieveThePairWithMostMatchesFirst) {
    const auto tracks = join_tracks({2, 1, 2}, {pair_of(0, 1, {{0, 0}}), pair_of(1, 2, {{0, 0}}),
                                                pair_of(0, 2, {{1, 0}, {0, 1}})});
    // 0:1 - 2:0 and 0:0 - 2:1 come first; then 0:0 - 1:0 joins, and 1:0 - 2:0 contradicts.
    EXPECT_THAT(tracks,
                ElementsAre(FeatureTrack{{0, 0}, {1, 0}, {2, 1}}, FeatureTrack{{0, 1}, {2, 0}}));
}

TEST(FeatureTracks, LeaveOutFeaturesWithoutAMatch) { EXPECT_TRUE(join_tracks({3, 3}, {}).empty()); }

}  // namespace
}  // namespace lumi
