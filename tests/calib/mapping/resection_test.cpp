#include "calib/mapping/resection.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/calib/synthetic_capture.h"

namespace lumi {
namespace {

struct Seen {
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector2d> rays;
};

Seen seen_from(const Rigid3& pose, int count, int outliers) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> within(-1, 1);
    Seen seen;
    for (int index = 0; index < count; ++index) {
        seen.points.emplace_back(within(random), within(random), within(random));
        const Eigen::Vector2d exact = (pose * seen.points.back()).hnormalized();
        const Eigen::Vector2d anywhere(within(random), within(random));
        seen.rays.push_back(index < outliers ? anywhere : exact);
    }
    return seen;
}

void expect_equal(const Rigid3& a, const Rigid3& b) {
    EXPECT_LT(a.rotation.angularDistance(b.rotation), 1e-7);
    EXPECT_LT((a.translation - b.translation).norm(), 1e-7);
}

TEST(Resection, FindsTheExactPose) {
    const Rigid3 pose = looking_at({1, 2, -4}, {0, 0, 0});
    const Seen seen = seen_from(pose, 40, 0);
    const auto found = resect(seen.points, seen.rays, 1000, {});
    ASSERT_TRUE(found.has_value());
    expect_equal(found->cam_from_world, pose);
    EXPECT_EQ(found->inliers, 40);
}

TEST(Resection, FindsItAmongThreeQuartersOfOutliers) {
    const Rigid3 pose = looking_at({-2, 1, -4}, {0.1, 0, 0});
    const Seen seen = seen_from(pose, 200, 150);
    const auto found = resect(seen.points, seen.rays, 1000, {});
    ASSERT_TRUE(found.has_value());
    expect_equal(found->cam_from_world, pose);
    EXPECT_GE(found->inliers, 50);
    EXPECT_LE(found->inliers, 53);  // Chance may put an outlier close to its place.
}

TEST(Resection, IsTheSameInEveryRun) {
    const Seen seen = seen_from(looking_at({-2, 1, -4}, {0, 0, 0}), 100, 60);
    const auto once = resect(seen.points, seen.rays, 1000, {});
    const auto again = resect(seen.points, seen.rays, 1000, {});
    EXPECT_EQ(once->cam_from_world.translation, again->cam_from_world.translation);
    EXPECT_EQ(once->is_inlier, again->is_inlier);
}

TEST(Resection, HasNoPoseForTooFewPoints) {
    const Seen seen = seen_from(looking_at({1, 2, -4}, {0, 0, 0}), 3, 0);
    EXPECT_FALSE(resect(seen.points, seen.rays, 1000, {}).has_value());
}

}  // namespace
}  // namespace lumi
