#include "pipeline/evaluate/depth_effort.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "tests/pipeline/studio.h"

namespace lumi {
namespace {

DepthEffort effort_in(Studio& studio, int given_views = 0) {
    studio.find_points();
    SilentProgress progress;
    const Lumigraph lumigraph = with_camera_mesh(studio);
    KeptBackPhotographs photographs(lumigraph, studio.capture, {}, progress);
    return sufficient_depth_effort(photographs, lumigraph.drawing, given_views);
}

TEST(DepthEffort, IsTheLeastWhereEachViewSeesEverything) {
    Studio studio = before_a_board(18, 0.01);
    const DepthEffort effort = effort_in(studio);
    EXPECT_EQ(effort.views, kLeastDepthViews);
    EXPECT_FALSE(effort.fills_holes);
    EXPECT_LT(effort.moved_know_more, 0.01);
    EXPECT_FALSE(effort.checks_guesses);
    EXPECT_NEAR(effort.guesses_lose_db, 0, 0.01);
    EXPECT_EQ(effort.pictures, 9);
    EXPECT_NEAR(effort.fewer_views_lose_db, 0, 0.1);
}

TEST(DepthEffort, IsForBlocksOfAPlaneWhichHasNoSilhouettes) {
    Studio studio = before_a_board(18, 0.04);
    const DepthEffort effort = effort_in(studio);
    EXPECT_EQ(effort.block_px, kMaxDepthBlock_px);
    EXPECT_NEAR(effort.blocks_lose_db, 0, 0.1);
}

TEST(DepthEffort, IsTheMostWhereEachViewSeesAPart) {
    Studio studio = before_a_board(18, 1.6);
    const DepthEffort effort = effort_in(studio);
    EXPECT_EQ(effort.views, kMaxDepthViews);
    EXPECT_GT(effort.fewer_views_lose_db, effort.standard_error_db);
}

TEST(DepthEffort, JudgesHolesWithAsManyViewsAsAreGiven) {
    Studio studio = before_a_board(18, 1.6);
    const DepthEffort asked = effort_in(studio);
    ASSERT_EQ(asked.views, kMaxDepthViews);
    EXPECT_EQ(effort_in(studio, kMaxDepthViews).holes_lose_db, asked.holes_lose_db);
    const DepthEffort of_few = effort_in(studio, kLeastDepthViews);
    EXPECT_EQ(of_few.views, kLeastDepthViews);
    EXPECT_EQ(of_few.fewer_views_lose_db, asked.fewer_views_lose_db);
    EXPECT_GT(of_few.holes_lose_db, asked.holes_lose_db) << "fewer views leave more holes";
}

/// Before an even background nothing has to be filled: it surrounds the scene.
const char* const kWallsAround = R"(
[[body]]
name = "walls"
material = "stone"
casts_shadow = false
solids = [
    { shape = "box", at = [3.6, 0, 0], size = [0.2, 7, 7] },
    { shape = "box", at = [-3.6, 0, 0], size = [0.2, 7, 7] },
    { shape = "box", at = [0, 3.6, 0], size = [7, 0.2, 7] },
    { shape = "box", at = [0, -3.6, 0], size = [7, 0.2, 7] },
    { shape = "box", at = [0, 0, 3.6], size = [7, 7, 0.2] },
    { shape = "box", at = [0, 0, -3.6], size = [7, 7, 0.2] },
]
)";

TEST(DepthEffort, FillsHolesWhereThingsHideOneAnother) {
    Studio studio = from_all_around((std::string(kBodiesInTheWay) + kWallsAround).c_str(), 40);
    const DepthEffort effort = effort_in(studio);
    EXPECT_TRUE(effort.fills_holes);
    EXPECT_GT(effort.holes_lose_db, 0.1);
}

/// Each photograph shows a part, and in its place the three nearest show nearly all of it.
TEST(DepthEffort, FillsHolesWhereEyesFartherAwayKnowMoreByIt) {
    Studio studio = before_a_board(18, 0.5);
    const DepthEffort effort = effort_in(studio);
    EXPECT_LT(std::abs(effort.holes_lose_db), 0.1);
    EXPECT_GT(effort.moved_know_more, 0.01);
    EXPECT_TRUE(effort.fills_holes);
}

TEST(DepthEffort, IsForEachPixelOfThinThingsThatStandApart) {
    Studio studio = from_all_around(kThinThings, 40);
    const DepthEffort effort = effort_in(studio);
    EXPECT_GE(effort.block_px, kLeastDepthBlock_px);
    EXPECT_LT(effort.block_px, kMaxDepthBlock_px);
    EXPECT_GT(effort.blocks_lose_db, 0.1);
}

TEST(DepthEffort, IsTheMostOfFewerThanEightViewsUnasked) {
    Studio studio = before_a_board(7, 0.04);
    const DepthEffort effort = effort_in(studio);
    EXPECT_EQ(effort.views, kMaxDepthViews);
    EXPECT_EQ(effort.block_px, kLeastDepthBlock_px);
    EXPECT_FALSE(effort.fills_holes);
    EXPECT_EQ(effort.pictures, 0);
}

}  // namespace
}  // namespace lumi
