#include "render/view_choice/nearest_views.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/paths/pose_between.h"
#include "render/view_choice/view_sight.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr std::size_t kAll = 100;

std::vector<Eigen::Vector2d> middles_of_cells(const Camera& camera) {
    std::vector<Eigen::Vector2d> middles;
    for (int row = 0; row < kSightSteps; ++row)
        for (int column = 0; column < kSightSteps; ++column)
            middles.emplace_back((column + 0.5) * camera.width_px / kSightSteps,
                                 (row + 0.5) * camera.height_px / kSightSteps);
    return middles;
}

TEST(NearestViews, BeginWithTheViewThatStandsWhereTheEyeIs) {
    const Lumigraph lumigraph = ball_in_sky();
    for (std::size_t view = 0; view < lumigraph.views.size(); ++view) {
        const Eye eye{lumigraph.views[view].camera, lumigraph.views[view].cam_from_world};
        const Eigen::Vector2d middle(0.5 * eye.camera.width_px, 0.5 * eye.camera.height_px);
        const NearestViews nearest(lumigraph, eye, {middle}, kAll);
        ASSERT_FALSE(nearest.at(middle).empty());
        EXPECT_EQ(nearest.at(middle).front(), static_cast<int>(view));
    }
}

// Cameras in a row before a wall, the eye in the row: what is straight ahead is seen at an angle
// that grows with how far a camera stands to the side.
TEST(NearestViews, ComeInTheOrderOfTheirAngles) {
    const Camera wide = pinhole_camera(96, 72, 40);
    std::vector<Eye> cameras;
    for (const double x : {1.5, -0.2, 0.7, -1.1, 0.4})
        cameras.push_back(eye_at({x, 0, 0}, {x, 0, 6}, wide));
    const Lumigraph lumigraph = photographed(AnalyticScene::kCardBeforeWall, cameras);
    const Eye eye = eye_at({0, 0, 0}, {0, 0, 6}, wide);
    const Eigen::Vector2d ahead(48, 36);
    EXPECT_EQ(NearestViews(lumigraph, eye, {ahead}, kAll).at(ahead),
              (std::vector<int>{1, 4, 2, 3, 0}));
    EXPECT_EQ(NearestViews(lumigraph, eye, {ahead}, 2).at(ahead), (std::vector<int>{1, 4}));
}

TEST(NearestViews, LeaveOutThoseThatDoNotSeeThePlace) {
    const Camera narrow = pinhole_camera(64, 48, 400);
    const Lumigraph lumigraph = photographed(
        AnalyticScene::kCardBeforeWall,
        {eye_at({-0.5, 0, 0}, {-2, 0, 6}, narrow), eye_at({0.5, 0, 0}, {2, 0, 6}, narrow)});
    const Eye eye = eye_at({0, 0, -1}, {0, 0, 6}, pinhole_camera(96, 72, 80));
    const Eigen::Vector2d left(20, 36);
    const Eigen::Vector2d right(76, 36);
    const Eigen::Vector2d top(48, 1);
    const NearestViews nearest(lumigraph, eye, {left, right, top}, kAll);
    EXPECT_EQ(nearest.at(left), std::vector<int>{0});
    EXPECT_EQ(nearest.at(right), std::vector<int>{1});
    EXPECT_TRUE(nearest.at(top).empty());
}

TEST(NearestViews, AreNoneWhereNoneAreAskedFor) {
    const Lumigraph lumigraph = ball_in_sky();
    const Eye eye = eye_at({1, -2, -7}, {0, 0, 0}, pinhole_camera(64, 48, 60));
    EXPECT_TRUE(NearestViews(lumigraph, eye, {}, kAll).at({32, 24}).empty());
}

// A choice for the whole picture would change everywhere at once.
TEST(NearestViews, ChangePlacesInFewCellsAtOnce) {
    const Lumigraph lumigraph = ball_in_sky();
    const Eye from = eye_at({1, -2, -7}, {0, 0, 0}, pinhole_camera(64, 48, 60));
    const Eye to = eye_at({-3, 1, -5}, {0, 0.2, 0}, pinhole_camera(64, 48, 60));
    const std::vector<Eigen::Vector2d> cells = middles_of_cells(from.camera);
    constexpr int kEyes = 2000;
    std::vector<std::vector<int>> before;
    std::size_t most = 0;
    std::size_t all = 0;
    for (int i = 0; i <= kEyes; ++i) {
        const Eye eye{from.camera, pose_between(from.cam_from_world, to.cam_from_world,
                                                static_cast<double>(i) / kEyes)};
        const NearestViews nearest(lumigraph, eye, cells, 3);
        std::vector<std::vector<int>> now;
        for (const Eigen::Vector2d& cell : cells) now.push_back(nearest.at(cell));
        if (!before.empty()) {
            std::size_t changed = 0;
            for (std::size_t k = 0; k < cells.size(); ++k) changed += now[k] != before[k] ? 1U : 0U;
            most = std::max(most, changed);
            all += changed;
        }
        before = std::move(now);
    }
    EXPECT_GT(all, cells.size());
    EXPECT_LE(most, cells.size() / 16);
}

}  // namespace
}  // namespace lumi
