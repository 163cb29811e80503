#include "calib/doctor/match_loops.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

/// Three photographs with `count` features each at distant places, and all three pairs; feature i
/// matches feature i, but between the first and the last photograph feature i + shift.
struct Triplet {
    std::vector<ColmapPhotograph> photographs;
    std::vector<VerifiedPair> pairs;

    explicit Triplet(std::uint32_t count, std::uint32_t shift) {
        ColmapPhotograph photograph;
        for (std::uint32_t index = 0; index < count; ++index) {
            photograph.keypoints_px.emplace_back(static_cast<float>(20 * index), 5.0F);
        }
        photographs.assign(3, photograph);
        for (const auto& [first, second] :
             std::vector<std::pair<int, int>>{{0, 1}, {1, 2}, {0, 2}}) {
            VerifiedPair pair{first, second, PairConfiguration::kUncalibrated, {}};
            for (std::uint32_t index = 0; index < count; ++index) {
                const std::uint32_t other = first == 0 && second == 2 ? index + shift : index;
                if (other < count) pair.inliers.push_back({index, other});
            }
            pairs.push_back(pair);
        }
    }
    [[nodiscard]] MatchLoops followed() const {
        std::vector<const VerifiedPair*> pointers;
        for (const VerifiedPair& pair : pairs) pointers.push_back(&pair);
        return follow_matches(photographs, pointers);
    }
};

TEST(MatchLoops, TrueMatchesClose) {
    const MatchLoops loops = Triplet(30, 0).followed();
    EXPECT_EQ(loops.closed, 90);
    EXPECT_EQ(loops.conflict_share(), 0.0);
}

TEST(MatchLoops, MatchesBetweenThingsThatLookAlikeDoNot) {
    const MatchLoops loops = Triplet(30, 4).followed();
    EXPECT_EQ(loops.closed, 0);
    EXPECT_EQ(loops.conflict_share(), 1.0);
}

TEST(MatchLoops, TwoFeaturesOfOnePlaceAreOne) {
    Triplet triplet(30, 1);
    for (ColmapPhotograph& photograph : triplet.photographs) {
        for (std::size_t index = 0; index < 30; ++index) {
            photograph.keypoints_px[index].x() = static_cast<float>(index);
        }
    }
    EXPECT_EQ(triplet.followed().conflicts, 0);
}

TEST(MatchLoops, TwoPhotographsMakeNoLoop) {
    Triplet triplet(30, 4);
    triplet.pairs.pop_back();
    EXPECT_EQ(triplet.followed().closed + triplet.followed().conflicts, 0);
}

}  // namespace
}  // namespace lumi
