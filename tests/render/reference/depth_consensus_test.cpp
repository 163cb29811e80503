#include "render/reference/depth_consensus.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

constexpr EyeDepth kNothing{};

EyeDepth seen(double inverse_depth) { return {inverse_depth, DepthKind::kSeen}; }
EyeDepth filled(double inverse_depth) { return {inverse_depth, DepthKind::kFilled}; }

TEST(DepthConsensus, LeavesOutWhatOneViewImaginesInFront) {
    const ConsensusDepth depth = consensus_of({seen(0.9), seen(0.30), seen(0.31)}, 0.02);
    EXPECT_NEAR(depth.inverse_depth, 0.305, 1e-12);
    EXPECT_EQ(depth.support, 2);
    EXPECT_EQ(depth.best_layer, 1);
}

TEST(DepthConsensus, PrefersTheNearerOfTwoSurfacesThatPairsAgreeOn) {
    const ConsensusDepth depth = consensus_of({seen(0.3), seen(0.8), seen(0.3), seen(0.8)}, 0.02);
    EXPECT_NEAR(depth.inverse_depth, 0.8, 1e-12);
    EXPECT_EQ(depth.best_layer, 1);
}

TEST(DepthConsensus, TakesTheNearestWhenNoTwoAgree) {
    const ConsensusDepth depth = consensus_of({seen(0.3), kNothing, seen(0.5)}, 0.02);
    EXPECT_NEAR(depth.inverse_depth, 0.5, 1e-12);
    EXPECT_EQ(depth.support, 1);
    EXPECT_EQ(depth.best_layer, 2);
}

TEST(DepthConsensus, FilledDepthNeverHidesWhatWasSeen) {
    const ConsensusDepth depth = consensus_of({filled(0.9), filled(0.9), seen(0.2)}, 0.02);
    EXPECT_NEAR(depth.inverse_depth, 0.2, 1e-12);
    EXPECT_EQ(depth.kind, DepthKind::kSeen);
}

TEST(DepthConsensus, OfFillsTheFarthestContinuesTheBackground) {
    const ConsensusDepth depth = consensus_of({filled(0.9), filled(0.2), kNothing}, 0.02);
    EXPECT_NEAR(depth.inverse_depth, 0.2, 1e-12);
    EXPECT_EQ(consensus_of({filled(0.2), filled(0.9)}, 0.02).best_layer, 0);
}

TEST(DepthConsensus, KnowsAnInfinitelyFarSky) {
    const ConsensusDepth depth = consensus_of({seen(0), seen(0)}, 0.02);
    EXPECT_EQ(depth.inverse_depth, 0);
    EXPECT_EQ(depth.support, 2);
}

TEST(DepthConsensus, KnowsNothingFromNothing) {
    EXPECT_EQ(consensus_of({kNothing, kNothing}, 0.02).support, 0);
}

TEST(SettleLoneSurface, TakesAwayWhatLiesBehindUnlessAViewThatAgreesLooksPast) {
    const std::vector<EyeDepth> asked{seen(0.9), seen(0.30), kNothing, seen(0.31)};
    std::vector<EyeDepth> settled = asked;
    settle_lone_surface(settled, 0.02, [](std::size_t layer, double inverse_depth, double) {
        EXPECT_TRUE(layer == 1 || layer == 3);
        EXPECT_EQ(inverse_depth, 0.9);
        return Past::kNot;
    });
    EXPECT_EQ(consensus_of(settled, 0.02).inverse_depth, 0.9);
    EXPECT_FALSE(settled[1].is_known());
    EXPECT_FALSE(settled[3].is_known());
    settled = asked;
    settle_lone_surface(settled, 0.02, [](std::size_t layer, double, double) {
        return layer == 3 ? Past::kPerhaps : Past::kNot;
    });
    EXPECT_NEAR(consensus_of(settled, 0.02).inverse_depth, 0.305, 1e-12);
}

TEST(SettleLoneSurface, WhereNoTwoAgreeTakesAwayWhatOneSurelyLooksPast) {
    const std::vector<EyeDepth> asked{seen(0.3), seen(0.9), seen(0.6)};
    const auto settled = [&](Past of_first, Past of_last) {
        std::vector<EyeDepth> layers = asked;
        settle_lone_surface(layers, 0.02, [&](std::size_t layer, double, double) {
            return layer == 0 ? of_first : layer == 2 ? of_last : Past::kSurely;
        });
        return consensus_of(layers, 0.02).inverse_depth;
    };
    EXPECT_EQ(settled(Past::kNot, Past::kPerhaps), 0.9);
    EXPECT_EQ(settled(Past::kNot, Past::kSurely), 0.6);
    EXPECT_EQ(settled(Past::kSurely, Past::kNot), 0.3);  // Past both.
}

TEST(SettleLoneSurface, WhereTwoSeeNothingAsksWhoSeesNothingPastItEither) {
    constexpr double kAgreeing = 0.02;
    constexpr double kSeenBehind = 0.2;  // By both, at the lone surface's place in their pictures.
    for (const double agreed : {0.0, 0.01, 0.3}) {
        std::vector<EyeDepth> settled{seen(0.9), seen(agreed), seen(agreed)};
        settle_lone_surface(settled, kAgreeing, [](std::size_t, double, double nearest_seen) {
            return kSeenBehind <= nearest_seen ? Past::kPerhaps : Past::kNot;
        });
        EXPECT_EQ(consensus_of(settled, kAgreeing).inverse_depth, agreed < 0.1 ? 0.9 : agreed);
    }
}

TEST(SettleLoneSurface, LeavesWhatIsNotSeenOrNotAloneAsItIs) {
    for (const Past past : {Past::kNot, Past::kSurely}) {
        for (const std::vector<EyeDepth>& asked :
             {std::vector<EyeDepth>{filled(0.9), seen(0.3), seen(0.3)},    // a fill before it
              std::vector<EyeDepth>{seen(0.9), filled(0.3), filled(0.3)},  // fills behind it
              std::vector<EyeDepth>{seen(0.9), seen(0.9), seen(0.3), seen(0.3)},
              std::vector<EyeDepth>{seen(0.9), kNothing},
              std::vector<EyeDepth>{kNothing, kNothing}}) {
            std::vector<EyeDepth> settled = asked;
            settle_lone_surface(settled, 0.02, [&](std::size_t, double, double) { return past; });
            for (std::size_t i = 0; i < asked.size(); ++i)
                EXPECT_EQ(settled[i].inverse_depth, asked[i].inverse_depth);
        }
    }
}

}  // namespace
}  // namespace lumi
