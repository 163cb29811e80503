#include "pipeline/evaluate/depth_view_count.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "pipeline/stages/chosen_views.h"
#include "pipeline/synth/hand_held_path.h"
#include "tests/pipeline/studio.h"

namespace lumi {
namespace {

/// A board photographed from so many places within a disc before it, whatever each of them shows.
Studio before_a_board(int count, double radius) {
    Studio studio(kFlatBoard);
    const double golden_angle = 2.4;
    for (int i = 0; i < count; ++i) {
        const double from_middle = radius * std::sqrt((i + 0.5) / count);
        const Eigen::Vector3d place(from_middle * std::cos(golden_angle * i),
                                    from_middle * std::sin(golden_angle * i), kStudioDistance);
        studio.photograph_from(looking_at(place, Eigen::Vector3d(place.x(), place.y(), 0)));
    }
    return studio;
}

DepthViewCount count_in(Studio& studio) {
    studio.find_points();
    std::vector<int> all(studio.capture.views.size());
    std::iota(all.begin(), all.end(), 0);
    SilentProgress progress;
    return sufficient_depth_views(lumigraph_of_views(studio.lumigraph, studio.capture, all, {}),
                                  studio.capture, {}, progress);
}

TEST(DepthViewCount, IsTheLeastWhereEachViewSeesEverything) {
    Studio studio = before_a_board(18, 0.04);
    const DepthViewCount count = count_in(studio);
    EXPECT_EQ(count.views, kLeastDepthViews);
    EXPECT_EQ(count.pictures, 9);
    EXPECT_NEAR(count.loss_db, 0, 0.1);
}

TEST(DepthViewCount, IsTheMostWhereEachViewSeesAPart) {
    Studio studio = before_a_board(18, 1.6);
    const DepthViewCount count = count_in(studio);
    EXPECT_EQ(count.views, kMaxDepthViews);
    EXPECT_GT(count.loss_db, count.standard_error_db);
}

TEST(DepthViewCount, IsTheMostOfFewerThanEightViewsUnasked) {
    Studio studio = before_a_board(7, 0.04);
    const DepthViewCount count = count_in(studio);
    EXPECT_EQ(count.views, kMaxDepthViews);
    EXPECT_EQ(count.pictures, 0);
}

}  // namespace
}  // namespace lumi
