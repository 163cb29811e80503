#include "pipeline/evaluate/triangle_effort.h"

#include <gtest/gtest.h>

#include <numeric>

#include "pipeline/stages/chosen_views.h"
#include "pipeline/synth/hand_held_path.h"
#include "tests/pipeline/studio.h"

namespace lumi {
namespace {

TriangleEffort effort_of(const Studio& studio) {
    std::vector<int> all(studio.capture.views.size());
    std::iota(all.begin(), all.end(), 0);
    SilentProgress progress;
    return sufficient_triangle_effort(lumigraph_of_views(studio.lumigraph, studio.capture, all, {}),
                                      studio.capture, {}, progress);
}

TEST(TriangleEffort, IsTheLeastWherePicturesShowTheSameEverywhere) {
    Studio studio = before_a_board(18, 0.1);
    studio.find_points();
    for (LumigraphView& view : studio.lumigraph.views)
        for (Rgb8& pixel : view.photograph.pixels()) pixel = {120, 130, 140};
    const TriangleEffort effort = effort_of(studio);
    EXPECT_EQ(effort.error_px, 4.0);
    EXPECT_EQ(effort.pictures, 9);
    EXPECT_NEAR(effort.loses_db, 0, 0.05);
    EXPECT_GT(effort.triangles, 0);
    EXPECT_EQ(effort.thin_gains_db, 0);
    EXPECT_FALSE(effort.draws_thin);
}

TEST(TriangleEffort, DrawsWhatIsThinWhereThatStandsApart) {
    Studio studio(kThinThings);
    for (const Eigen::Vector3d& direction : spiral(40, 0.0))
        studio.photograph_from(looking_at(kStudioDistance * direction, Eigen::Vector3d::Zero()));
    studio.find_points();
    const TriangleEffort effort = effort_of(studio);
    EXPECT_GT(effort.thin_gains_db, 0.1);
    EXPECT_GT(effort.thin_gains_db, effort.thin_standard_error_db);
    EXPECT_TRUE(effort.draws_thin);
}

TEST(TriangleEffort, IsGreaterWhereBodiesHideOneAnother) {
    Studio studio(kBodiesInTheWay);
    for (const Eigen::Vector3d& direction : spiral(40, 0.0))
        studio.photograph_from(looking_at(kStudioDistance * direction, Eigen::Vector3d::Zero()));
    studio.find_points();
    const TriangleEffort effort = effort_of(studio);
    EXPECT_LT(effort.error_px, 2.0);
    EXPECT_LE(effort.loses_db, 0.1);
}

TEST(TriangleEffort, IsAsUsualForFewerThanEightViewsUnasked) {
    Studio studio = before_a_board(7, 0.1);
    studio.find_points();
    const TriangleEffort effort = effort_of(studio);
    EXPECT_EQ(effort.error_px, kTriangleError_px);
    EXPECT_EQ(effort.pictures, 0);
}

}  // namespace
}  // namespace lumi
