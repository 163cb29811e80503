#include "render/paths/tour_through_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/paths/path_through_views.h"
#include "render/paths/photograph_eye.h"
#include "render/paths/pose_curve.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr double kMetresPerRad = 3.0;

Lumigraph through_poses(const std::vector<Rigid3>& poses) {
    Lumigraph lumigraph = card_before_wall();
    lumigraph.near_depth = kMetresPerRad / 2;
    lumigraph.far_depth = 1e9;  // In the middle of the inverse depths it is 3 away.
    lumigraph.views.resize(poses.size(), lumigraph.views.front());
    for (std::size_t i = 0; i < poses.size(); ++i) lumigraph.views[i].cam_from_world = poses[i];
    return lumigraph;
}

Rigid3 pose_of(const Eigen::Vector3d& centre, double yaw_rad, double roll_rad = 0.0) {
    const Eigen::AngleAxisd yaw(yaw_rad, Eigen::Vector3d::UnitY());
    const Eigen::AngleAxisd roll(roll_rad, Eigen::Vector3d::UnitZ());
    Rigid3 pose;
    pose.rotation = roll * yaw;
    pose.translation = -(pose.rotation * centre);
    return pose;
}

/// Steps of very different lengths, there and back, and turns of up to a third of a circle.
std::vector<Rigid3> uneven_poses() {
    return {pose_of({0, 0, 0}, 0.0),        pose_of({1, 0, 0}, 0.3),
            pose_of({1.1, 0.1, 0}, 0.2),    pose_of({0.2, 0.4, 0.1}, -0.4, 0.1),
            pose_of({0.2, 0.4, 0.1}, 0.5),  pose_of({3, 0.5, 0.2}, 0.5),
            pose_of({2.9, 0.5, 0.2}, -1.5), pose_of({3.5, 1, -1}, -1.2, -0.1)};
}

/// Way and turn of each step, the turn as a way.
std::vector<Eigen::VectorXd> steps_of(const std::vector<Eye>& path) {
    std::vector<Eigen::VectorXd> steps;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Rigid3& from = path[i - 1].cam_from_world;
        const Rigid3& to = path[i].cam_from_world;
        const Eigen::AngleAxisd turn(to.rotation.conjugate() * from.rotation);
        Eigen::VectorXd step(6);
        step << centre_in_world(to) - centre_in_world(from),
            kMetresPerRad * turn.angle() * turn.axis();
        steps.push_back(step);
    }
    return steps;
}

/// The largest change from a step to the next, over the longest step.
double jerkiness(const std::vector<Eye>& path) {
    const std::vector<Eigen::VectorXd> steps = steps_of(path);
    double longest = 0;
    double change = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        longest = std::max(longest, steps[i].norm());
        if (i > 0) change = std::max(change, (steps[i] - steps[i - 1]).norm());
    }
    return change / longest;
}

TEST(PoseCurve, LeadsThroughEachPoseToTheBitAndIsSmoothThere) {
    const std::vector<Rigid3> poses = uneven_poses();
    const PoseCurve curve(poses, kMetresPerRad);
    ASSERT_EQ(curve.pieces(), poses.size() - 1);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        EXPECT_EQ(curve.at(static_cast<double>(i)), poses[i]);
        if (i == 0 || i + 1 == poses.size()) continue;
        constexpr double kLittle = 1e-5;
        const Eye before{{}, curve.at(static_cast<double>(i) - kLittle)};
        const Eye after{{}, curve.at(static_cast<double>(i) + kLittle)};
        const std::vector<Eigen::VectorXd> steps = steps_of({before, {{}, poses[i]}, after});
        EXPECT_GT(steps[0].dot(steps[1]) / (steps[0].norm() * steps[1].norm()), 1 - 1e-3) << i;
    }
}

TEST(PoseCurve, GoesAroundWhatARingOfCamerasLooksAt) {
    std::vector<Rigid3> ring;
    for (int i = 0; i < 12; ++i) {
        const double angle = i * std::numbers::pi / 6;
        ring.push_back(pose_of({-2 * std::sin(angle), 0, -2 * std::cos(angle)}, -angle));
    }
    const PoseCurve curve(ring, 2.0);
    for (double place = 1; place < 10; place += 0.125) {
        const Rigid3 pose = curve.at(place);
        // The chord between two comes as near as 1.93.
        EXPECT_NEAR(centre_in_world(pose).norm(), 2, 0.01) << place;
        EXPECT_LT((pose * Eigen::Vector3d(0, 0, 0) - Eigen::Vector3d(0, 0, 2)).norm(), 0.03);
    }
}

TEST(TourThroughViews, ComesToEveryPhotographInItsOrderAndIsNeverJerky) {
    const Lumigraph lumigraph = through_poses(uneven_poses());
    const std::vector<Eye> tour = tour_through_views(lumigraph, 2000, 64, 48);
    ASSERT_EQ(tour.size(), 2000U);
    std::size_t at = 0;
    for (const LumigraphView& view : lumigraph.views) {
        const auto distance = [&](const Eye& eye) {
            return pose_distance(eye.cam_from_world, eye_at(view).cam_from_world, kMetresPerRad);
        };
        while (at < tour.size() && distance(tour[at]) > 0.02) ++at;
        EXPECT_LT(at, tour.size()) << view.cam_from_world.translation.transpose();
    }
    EXPECT_EQ(tour.front().cam_from_world, eye_at(lumigraph.views.front()).cam_from_world);
    EXPECT_EQ(tour.back().cam_from_world, eye_at(lumigraph.views.back()).cam_from_world);

    // At 60 frames a piece the straight path stops, starts and turns within one frame.
    EXPECT_LT(jerkiness(tour_through_views(lumigraph, 7 * 60, 64, 48)), 0.1);
    EXPECT_GT(jerkiness(path_through_views(lumigraph, 7 * 60, 64, 48)), 0.8);
}

TEST(TourThroughViews, IsAtRestAtBothEndsAndElsewhereAsFastInLongPiecesAsInShortOnes) {
    std::vector<Rigid3> row;
    for (const double x : {0.0, 1.0, 2.0, 2.2, 2.4, 5.0, 6.0}) row.push_back(pose_of({x, 0, 0}, 0));
    const auto steps = steps_of(tour_through_views(through_poses(row), 601, 64, 48));
    const double longest = std::max_element(steps.begin(), steps.end(), [](auto& a, auto& b) {
                               return a.norm() < b.norm();
                           })->norm();
    EXPECT_LT(steps.front().norm(), 0.05 * longest);
    EXPECT_LT(steps.back().norm(), 0.05 * longest);
    for (std::size_t i = 100; i < 500; ++i) EXPECT_NEAR(steps[i].norm(), longest, 0.01 * longest);
}

TEST(TourThroughViews, RestsWhereAllPhotographsWereTakenAtOnePlace) {
    const std::vector<Rigid3> same(3, pose_of({1, 2, 3}, 0.4));
    for (const Eye& eye : tour_through_views(through_poses(same), 5, 64, 48))
        EXPECT_EQ(eye.cam_from_world, same.front());
    const std::vector<Rigid3> twice{same[0], same[0], pose_of({1, 2, 3}, 1.4), same[0]};
    for (const Eye& eye : tour_through_views(through_poses(twice), 50, 64, 48)) {
        EXPECT_TRUE(is_rigid(eye.cam_from_world));
        EXPECT_LT((centre_in_world(eye.cam_from_world) - Eigen::Vector3d(1, 2, 3)).norm(), 1e-9);
    }
}

TEST(TourThroughViews, StandsUprightAndShowsTheWholePhotographWhereverItsMiddleIs) {
    Lumigraph lumigraph = card_before_wall();
    for (LumigraphView& view : lumigraph.views) view.exif_orientation = 6;
    Camera& camera = lumigraph.views.front().camera;
    camera.parameters[3] += 5;
    const Eye expected = fitted_to(eye_at(lumigraph.views.front()), 96, 128);
    const Eye first = tour_through_views(lumigraph, 2, 96, 128).front();
    EXPECT_EQ(first.camera, expected.camera);
    EXPECT_EQ(first.cam_from_world, expected.cam_from_world);
}

}  // namespace
}  // namespace lumi
