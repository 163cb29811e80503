#include "calib/doctor/match_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lumi {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(MatchGraph, GroupsArePhotographsThatHangTogetherLargestFirst) {
    const MatchGraph graph{6, {{0, 1}, {3, 4}, {4, 5}}};
    EXPECT_THAT(groups_of(graph),
                ElementsAre(ElementsAre(3, 4, 5), ElementsAre(0, 1), ElementsAre(2)));
}

TEST(MatchGraph, APhotographBetweenTwoTrianglesIsABridge) {
    const MatchGraph graph{5, {{0, 1}, {0, 2}, {1, 2}, {2, 3}, {2, 4}, {3, 4}}};
    EXPECT_THAT(bridging_photographs(graph), ElementsAre(2));
}

TEST(MatchGraph, InAChainAllButTheEndsAreBridges) {
    const MatchGraph graph{4, {{0, 1}, {1, 2}, {2, 3}}};
    EXPECT_THAT(bridging_photographs(graph), ElementsAre(1, 2));
}

TEST(MatchGraph, ARingHasNoBridge) {
    const MatchGraph graph{4, {{0, 1}, {1, 2}, {2, 3}, {0, 3}}};
    EXPECT_THAT(bridging_photographs(graph), IsEmpty());
    EXPECT_EQ(groups_of(graph).size(), 1u);
}

TEST(MatchGraph, NothingIsNoGroup) { EXPECT_THAT(groups_of({}), IsEmpty()); }

}  // namespace
}  // namespace lumi
