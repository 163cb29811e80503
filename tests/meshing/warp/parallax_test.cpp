#include "meshing/warp/parallax.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Parallax, IsWhatStandsAsideByAFairShareOfTheFastest) {
    EXPECT_THAT(with_parallax({0.001, 1, 0.002, 3, 2}, 4), ElementsAre(1, 3, 4));
    EXPECT_THAT(with_parallax({0.001, 1, 0.002, 3, 2}, 1), ElementsAre(1));
    EXPECT_THAT(with_parallax({}, 4), IsEmpty());
}

TEST(Parallax, NearestDistancesAreThoseOfAnyOtherCamera) {
    EXPECT_THAT(nearest_distances({{0, 0, 0}, {0, 3, 0}, {0, 4, 0}, {0, 4, 0}}),
                ElementsAre(3, 1, 0, 0));
    EXPECT_THAT(nearest_distances({{1, 2, 3}}),
                ElementsAre(std::numeric_limits<double>::infinity()));
    EXPECT_THAT(nearest_distances({}), IsEmpty());
}

TEST(Parallax, TheNearestOfEvenlySpacedCamerasHasIt) {
    std::vector<Eigen::Vector3d> row;
    for (int i = 0; i < 40; ++i) row.emplace_back(0.3 * i, 0, 0);
    EXPECT_NEAR(nearest_baseline(row[0], row), 0.3, 1e-12);
    EXPECT_NEAR(nearest_baseline(row[20], row), 0.3, 1e-12);
}

TEST(Parallax, AnotherCameraOfABurstHasNone) {
    std::vector<Eigen::Vector3d> bursts;
    for (int i = 0; i < 25; ++i) bursts.emplace_back(0.3 * (i / 5) + 1e-4 * (i % 5), 0, 0);
    EXPECT_NEAR(nearest_baseline(bursts[12], bursts), 0.3, 1e-3);
    EXPECT_EQ(nearest_baseline({1, 2, 3}, {{1, 2, 3}, {1, 2, 3}}), 0.0);
}

TEST(Parallax, OfACameraAsideIsItsDistanceInFocalLengths) {
    DepthView view;
    view.camera = small_camera();
    view.range = {0.1, 1.0};
    DepthView other = view;
    other.cam_from_world = looking_ahead_from({0.2, 0, 0});
    EXPECT_NEAR(disparity_px_per_inverse_depth(view, other), 0.2 * 220, 1e-9);
}

}  // namespace
}  // namespace lumi
