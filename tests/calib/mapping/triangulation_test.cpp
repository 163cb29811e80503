#include "calib/mapping/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/calib/synthetic_capture.h"

namespace lumi {
namespace {

const Eigen::Vector3d kPoint(0.3, -0.2, 0.1);

Sighting sighting_from(const Eigen::Vector3d& centre, const Eigen::Vector3d& point = kPoint) {
    const Rigid3 pose = looking_at(centre, {0, 0, 0});
    return {pose, (pose * point).hnormalized(), 1000};
}

std::vector<Sighting> four_sightings() {
    return {sighting_from({0, 0, -5}), sighting_from({1, 0, -5}), sighting_from({0, 1, -5}),
            sighting_from({-2, 0.5, -4})};
}

TEST(Triangulation, FindsThePointThatExactSightingsShow) {
    const auto found = triangulate(four_sightings(), {});
    ASSERT_TRUE(found.has_value());
    EXPECT_LT((found->position_in_world - kPoint).norm(), 1e-10);
    EXPECT_EQ(found->is_inlier, std::vector<char>(4, 1));
}

TEST(Triangulation, LeavesOutTheSightingThatContradicts) {
    std::vector<Sighting> sightings = four_sightings();
    sightings[1].ray += Eigen::Vector2d(0.05, -0.03);
    const auto found = triangulate(sightings, {});
    ASSERT_TRUE(found.has_value());
    EXPECT_LT((found->position_in_world - kPoint).norm(), 1e-10);
    EXPECT_EQ(found->is_inlier, (std::vector<char>{1, 0, 1, 1}));
}

TEST(Triangulation, LeavesOutTheSightingThatContradictsHoweverManyOthersThereAre) {
    for (int others = 3; others <= 12; ++others) {
        // Seen from the far left, and so in the pairs of rays that differ most.
        std::vector<Sighting> sightings{sighting_from({-5, 0, -5})};
        sightings[0].ray += Eigen::Vector2d(0, 0.3);
        for (int other = 0; other < others; ++other) {
            sightings.push_back(sighting_from({3.0 * (other + 1) / others, 0.1 * other, -5}));
        }
        const auto found = triangulate(sightings, {});
        ASSERT_TRUE(found.has_value()) << others;
        EXPECT_LT((found->position_in_world - kPoint).norm(), 1e-10) << others;
        EXPECT_EQ(std::count(found->is_inlier.begin(), found->is_inlier.end(), 1), others);
        EXPECT_EQ(found->is_inlier.front(), 0) << others;
    }
}

TEST(Triangulation, HasNoPointForRaysThatAreNearlyParallel) {
    EXPECT_FALSE(
        triangulate(std::vector{sighting_from({0, 0, -5}), sighting_from({0.1, 0, -5})}, {})
            .has_value());
    EXPECT_FALSE(triangulate(std::vector{sighting_from({0, 0, -5}), sighting_from({0, 0, -5})}, {})
                     .has_value());
}

TEST(Triangulation, HasNoPointBehindTheCameras) {
    // Side by side, looking ahead; the rays part, and meet behind.
    const Rigid3 beside{Eigen::Quaterniond::Identity(), {-1, 0, 0}};
    const std::vector<Sighting> sightings{{{}, {-0.1, 0}, 1000}, {beside, {0.1, 0}, 1000}};
    EXPECT_FALSE(triangulate(sightings, {}).has_value());
}

TEST(Triangulation, HasNoPointForFewerThanTwoSightings) {
    EXPECT_FALSE(triangulate(std::vector<Sighting>{}, {}).has_value());
    EXPECT_FALSE(triangulate(std::vector{sighting_from({0, 0, -5})}, {}).has_value());
}

TEST(Triangulation, RefinedPointHasTheLeastSquaredPixels) {
    std::vector<Sighting> sightings = four_sightings();
    sightings[0].ray += Eigen::Vector2d(1e-3, 0);
    sightings[2].ray += Eigen::Vector2d(0, -1e-3);
    const std::vector<char> all(4, 1);
    const Eigen::Vector3d best = refined_point(sightings, all, kPoint);
    const auto cost = [&](const Eigen::Vector3d& point) {
        double sum = 0;
        for (const Sighting& sighting : sightings) {
            sum += std::pow(sighting_error_px(sighting, point), 2);
        }
        return sum;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const double step : {-1e-4, 1e-4}) {
            EXPECT_LT(cost(best), cost(best + step * Eigen::Vector3d::Unit(axis)));
        }
    }
}

TEST(Triangulation, LargestAngleIsBetweenTheCamerasFarthestApart) {
    const std::vector<Sighting> sightings{sighting_from({0, 0, -5}), sighting_from({5, 0, 0}),
                                          sighting_from({1, 0, -5})};
    EXPECT_NEAR(largest_angle_rad(sightings, {1, 1, 1}, Eigen::Vector3d::Zero()),
                std::numbers::pi / 2, 1e-12);
    EXPECT_NEAR(largest_angle_rad(sightings, {1, 0, 1}, Eigen::Vector3d::Zero()),
                std::atan2(1.0, 5.0), 1e-12);
}

}  // namespace
}  // namespace lumi
