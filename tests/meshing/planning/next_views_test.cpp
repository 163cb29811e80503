#include "meshing/planning/next_views.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "calib/capture/angle_between.h"
#include "calib/capture/degrees.h"
#include "calib/capture/rigid3.h"
#include "calib/work/error.h"
#include "calib/work/median.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

Capture around(const Points& centres) {
    std::mt19937 random(1);
    return capture_of(centres, Eigen::Vector3d::Zero(),
                      points_in_ball(200, Eigen::Vector3d::Zero(), 0.5, random));
}

/// All around at distance 3, without the cameras within `gap_deg` of +x.
Points all_around_with_gap(int count, double gap_deg) {
    Points centres;
    for (const Eigen::Vector3d& direction : sphere_directions(count, -1)) {
        if (angle_between(direction, Eigen::Vector3d::UnitX()) > gap_deg * kRadiansPerDegree) {
            centres.push_back(3 * direction);
        }
    }
    return centres;
}

TEST(CapturePlan, PlacesTheFirstViewIntoTheGapOfAnAllAroundCapture) {
    for (const double gap_deg : {35.0, 45.0, 60.0}) {
        const Capture capture = around(all_around_with_gap(80, gap_deg));
        const CapturePlan plan = plan_capture(capture, all_views(capture), {});
        ASSERT_EQ(plan.suggestions.size(), 5U);
        const SuggestedView& first = plan.suggestions.front();
        const Eigen::Vector3d place = centre_in_world(first.cam_from_world);
        EXPECT_LT(angle_between(place, Eigen::Vector3d::UnitX()), 0.5 * gap_deg * kRadiansPerDegree)
            << gap_deg;
        EXPECT_NEAR(place.norm(), 3, 0.2);
        // It looks at the scene.
        EXPECT_LT(angle_between(optical_axis_in_world(first.cam_from_world), -place), 0.05);
        // Each suggestion leaves less to do, and none is worse than the one before.
        double before = first.error_px;
        for (const SuggestedView& view : plan.suggestions) {
            EXPECT_LE(view.error_px, before + 1e-9);
            EXPECT_LE(view.worst_error_after_px, view.error_px + 1e-9);
            before = view.error_px;
        }
    }
}

/// From the middle of a room of radius 6: what is missing is photographed outwards, and the subject
/// is the wall.
TEST(CapturePlan, LooksOutwardsWhereTheOthersDo) {
    Points centres = all_around_with_gap(80, 40);
    for (Eigen::Vector3d& centre : centres) centre *= 0.4 / 3;
    std::mt19937 random(3);
    Points walls;
    for (int i = 0; i < 400; ++i) walls.push_back(6 * random_direction(random));
    Capture capture = capture_of(centres, Eigen::Vector3d::Zero(), walls);
    for (View& view : capture.views) {
        const Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
        view.cam_from_world.rotation = turn_between(centre, Eigen::Vector3d::UnitZ());
        view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
    }
    for (ScenePoint& point : capture.points) {
        std::erase_if(point.track, [&](const Observation& seen) {
            const auto view = static_cast<std::size_t>(seen.view_index);
            return (capture.views[view].cam_from_world * point.position_in_world).z() < 4;
        });
    }
    const CapturePlan plan = plan_capture(capture, all_views(capture), {});
    ASSERT_FALSE(plan.suggestions.empty());
    const SuggestedView& first = plan.suggestions.front();
    const Eigen::Vector3d place = centre_in_world(first.cam_from_world);
    EXPECT_LT(angle_between(place, Eigen::Vector3d::UnitX()), 20 * kRadiansPerDegree);
    EXPECT_NEAR(place.norm(), 0.4, 0.05);
    EXPECT_LT(angle_between(optical_axis_in_world(first.cam_from_world), place), 0.1);
    // Steps are shares of the way to the wall.
    std::vector<double> depths;
    for (const OpticalAxis& axis : optical_axes(capture, all_views(capture)))
        depths.push_back(axis.depth);
    const double to_wall = median_of(depths);
    EXPECT_GT(to_wall, 4);
    const auto nearest = static_cast<std::size_t>(first.nearest_views[0]);
    EXPECT_EQ(first.steps[0],
              steps_in_words(capture.views[nearest].cam_from_world, place, to_wall));
}

TEST(CapturePlan, PlacesAViewIntoTheGapOfARow) {
    Points row;
    for (const double y : {-1.5, -1.2, -0.9, -0.6, 0.3, 0.6, 0.9, 1.2}) row.emplace_back(4, y, 0);
    const Capture capture = around(row);
    const CapturePlan plan = plan_capture(capture, all_views(capture), {.suggestions = 1});
    ASSERT_EQ(plan.suggestions.size(), 1U);
    const Eigen::Vector3d place = centre_in_world(plan.suggestions[0].cam_from_world);
    EXPECT_NEAR(place.y(), -0.15, 0.1);
    EXPECT_NEAR(place.z(), 0.0, 0.1);
    const auto& nearest = plan.suggestions[0].nearest_views;
    EXPECT_EQ(nearest[0] + nearest[1], 3 + 4);
}

TEST(CapturePlan, PlacesAViewBetweenThreePhotographs) {
    const Capture capture = around({{3, -0.5, -0.3}, {3, 0.5, -0.3}, {3, 0, 0.6}});
    const CapturePlan plan = plan_capture(capture, all_views(capture), {.suggestions = 1});
    ASSERT_EQ(plan.suggestions.size(), 1U);
    const Eigen::Vector3d place = centre_in_world(plan.suggestions[0].cam_from_world);
    EXPECT_LT(angle_between(place, Eigen::Vector3d::UnitX()), 2 * kRadiansPerDegree);
}

/// error = focal length * deviation of inverse depth * distance across the hole.
TEST(PredictedError, IsThatOfItsFormulaOverAnOctahedron) {
    Points centres;
    for (int axis = 0; axis < 3; ++axis) {
        centres.push_back(2 * Eigen::Vector3d::Unit(axis));
        centres.push_back(-2 * Eigen::Vector3d::Unit(axis));
    }
    Capture capture = around(centres);
    const auto star =
        camera_star(optical_axes(capture, all_views(capture)), Eigen::Vector3d::Zero());
    const DepthUncertainty uncertainty{500, 0.01};
    const auto holes = holes_between(star, false, Eigen::Vector3d::UnitZ(), uncertainty);
    ASSERT_EQ(holes.size(), 8U);
    for (const Hole& hole : holes) {
        EXPECT_NEAR(hole.radius_rad, std::acos(1 / std::sqrt(3.0)), 1e-12);
        EXPECT_NEAR(hole.error_px, 500 * 0.01 * 2 * 2 * std::sqrt(2.0 / 3), 1e-9);
        EXPECT_EQ(hole.view_indices.size(), 3U);
    }
}

TEST(PredictedError, IsThatInTheMiddleOfASquareOfCameras) {
    const Capture capture = around({{3, -1, -1}, {3, 1, -1}, {3, -1, 1}, {3, 1, 1}});
    const auto star =
        camera_star(optical_axes(capture, all_views(capture)), Eigen::Vector3d::Zero());
    const auto holes = holes_between(star, false, Eigen::Vector3d::UnitZ(), {500, 0.01});
    ASSERT_EQ(holes.size(), 2U);
    for (const Hole& hole : holes) {
        EXPECT_LT(angle_between(hole.direction, Eigen::Vector3d::UnitX()), 1e-6);
        EXPECT_NEAR(hole.radius_rad, std::atan(std::sqrt(2.0) / 3), 1e-9);
    }
}

TEST(PredictedError, TakesTheDepthsUncertaintyFromTheTracks) {
    Capture capture = capture_of({{0, 0, 0}, {1, 0, 0}}, {0.5, 0, 1e7}, {{0.5, 0, 10}});
    capture.points[0].error_px = 0.25;
    const auto star = camera_star(optical_axes(capture, {0, 1}), {0.5, 0, 10});
    const DepthUncertainty known = depth_uncertainty(capture, {0, 1}, star);
    EXPECT_NEAR(known.focal_length_px, 500, 1e-9);
    // The baseline across the ray is the cosine of the ray's slope.
    EXPECT_NEAR(known.inverse_depth, 0.25 / (500 * 10 / std::hypot(10, 0.5)), 1e-9);
    capture.points.clear();
    const DepthUncertainty assumed = depth_uncertainty(capture, {0, 1}, star);
    EXPECT_NEAR(assumed.inverse_depth, 0.5 / 500, 1e-12);
}

TEST(CapturePlan, CountsThePhotographsThatAWishTakes) {
    const Capture capture = around(all_around_with_gap(40, 0));
    const CapturePlan as_is = plan_capture(capture, all_views(capture), {.suggestions = 0});
    const double worst = as_is.holes.front().error_px;
    const auto count = [&](double wish) {
        return plan_capture(capture, all_views(capture),
                            {.suggestions = 0, .wished_error_px = wish})
            .photographs_for_wish;
    };
    EXPECT_EQ(count(worst + 1e-6), 0);
    const int for_half = count(worst / 2);
    const int for_third = count(worst / 3);
    EXPECT_GT(for_half, 40);  // half the spacing takes four times the cameras, about
    EXPECT_LT(for_half, 300);
    EXPECT_GT(for_third, 1.5 * for_half);
    EXPECT_EQ(count(worst / 1000), -1);
}

TEST(CapturePlan, SaysTheWayInTheCamerasOwnDirections) {
    const Rigid3 camera;  // at the origin, looking along +z, y down
    EXPECT_EQ(steps_in_words(camera, {2, -1, 0.5}, 10),
              "go right by 20 %, up by 10 %, closer by 5 % of the distance to the subject");
    EXPECT_EQ(steps_in_words(camera, {-1, 0.001, -3}, 10),
              "go left by 10 %, back by 30 % of the distance to the subject");
    EXPECT_EQ(steps_in_words(camera, {0, 0, 0.01}, 10), "stay there");
}

TEST(CapturePlan, RefusesAWalkRoundThatLooksAhead) {
    Points circle;
    for (int i = 0; i < 24; ++i) {
        const double angle = 15 * i * kRadiansPerDegree;
        circle.emplace_back(3 * std::cos(angle), 3 * std::sin(angle), 0);
    }
    Capture capture = around(circle);
    EXPECT_NO_THROW((void)plan_capture(capture, all_views(capture), {}));
    const Eigen::Quaterniond aside(
        Eigen::AngleAxisd(90 * kRadiansPerDegree, Eigen::Vector3d::UnitY()));
    for (View& view : capture.views) {
        const Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
        view.cam_from_world.rotation = aside * view.cam_from_world.rotation;
        view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
    }
    try {
        (void)plan_capture(capture, all_views(capture), {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-PLAN-NOSURFACE");
    }
}

TEST(CapturePlan, RefusesWhatHasNothingBetweenItsCameras) {
    const Capture one = around({{3, 0, 0}});
    EXPECT_THROW((void)plan_capture(one, {0}, {}), Error);
    EXPECT_THROW((void)plan_capture(one, {}, {}), Error);
    const Capture walk = around({{3, 0, 0}, {4, 0, 0}, {5, 0, 0}});
    EXPECT_THROW((void)plan_capture(walk, all_views(walk), {}), Error);
    const Capture sway = around({{3, 0.03, 0}, {4, -0.04, 0.02}, {5, 0.01, -0.03}, {6, 0, 0.04}});
    EXPECT_THROW((void)plan_capture(sway, all_views(sway), {}), Error);
}

}  // namespace
}  // namespace lumi
