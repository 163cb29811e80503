#include "meshing/depth_scene/neighbour_selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshing/depth_scene/depth_range.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

/// Views on a circle of this radius around the origin, looking inwards, `apart_deg` apart.
DepthScene arc(int count, double radius, double apart_deg) {
    DepthScene scene;
    for (int i = 0; i < count; ++i) {
        const double angle = i * apart_deg * std::numbers::pi / 180;
        DepthView view;
        view.camera = small_camera();
        view.cam_from_world.rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY());
        view.cam_from_world.translation = {0, 0, radius};
        scene.views.push_back(view);
    }
    return scene;
}

void choose_ranges(DepthScene& scene) {
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
        scene.views[i].range = inverse_depth_range(scene, static_cast<int>(i)).value();
    }
}

TEST(NeighbourSelection, TakesTheViewsOnEitherSide) {
    DepthScene scene = arc(9, 5.0, 6.0);
    choose_ranges(scene);
    const auto neighbours = select_neighbours(scene, 2);
    for (int i = 1; i < 8; ++i) {
        std::vector<int> found = neighbours[static_cast<std::size_t>(i)];
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, (std::vector<int>{i - 1, i + 1}));
    }
}

TEST(NeighbourSelection, LeavesOutViewsThatSeeNothingOfIt) {
    DepthScene scene = arc(4, 5.0, 90.0);
    choose_ranges(scene);
    for (const auto& neighbours : select_neighbours(scene, 4)) EXPECT_TRUE(neighbours.empty());
}

TEST(NeighbourSelection, FollowsTheTracksWhereThereAreSome) {
    DepthScene scene = arc(5, 5.0, 6.0);
    // All points were seen by views 0, 3 and 4 only.
    for (int i = 0; i < 40; ++i) {
        ScenePoint point;
        point.position_in_world = {0.02 * i - 0.4, 0.01 * i - 0.2, 0};
        for (const int view : {0, 3, 4}) {
            point.track.push_back({view, {0, 0}});
            scene.views[static_cast<std::size_t>(view)].points.push_back({{100, 80}, 0.2});
        }
        scene.points.push_back(point);
    }
    choose_ranges(scene);
    EXPECT_EQ(select_neighbours(scene, 4)[0], (std::vector<int>{3, 4}));
}

/// Views half a unit behind each other, looking along a way between walls that are 1.4 to its left
/// and right, each of which sees what lies before it.
DepthScene walk(int count) {
    DepthScene scene;
    for (int i = 0; i < count; ++i) {
        DepthView view;
        view.camera = small_camera();
        view.cam_from_world.translation = {0, 0, -0.5 * i};
        scene.views.push_back(view);
    }
    for (double z = 1; z < 20; z += 0.1) {
        for (const double x : {-1.4, 1.4}) {
            ScenePoint point;
            point.position_in_world = {x, 0.3 * std::sin(7 * z), z};
            for (int i = 0; i < count; ++i) {
                const DepthView& view = scene.views[static_cast<std::size_t>(i)];
                const auto pixel =
                    project(view.camera, view.cam_from_world * point.position_in_world);
                if (pixel && is_inside(view.camera, *pixel)) point.track.push_back({i, *pixel});
            }
            if (point.track.size() < 2) continue;
            for (const Observation& seen : point.track) {
                DepthView& view = scene.views[static_cast<std::size_t>(seen.view_index)];
                view.points.push_back(
                    {seen.pixel, 1 / (view.cam_from_world * point.position_in_world).z()});
            }
            scene.points.push_back(point);
        }
    }
    return scene;
}

TEST(NeighbourSelection, OnAWalkForwardTakesThoseThatSeeThingsOfTheSameSize) {
    constexpr int kViews = 16;
    DepthScene scene = walk(kViews);
    choose_ranges(scene);
    const auto neighbours = select_neighbours(scene, 4);
    // Six steps ahead angles are wider, but walls that both see are three times as large there.
    for (int i = 0; i < kViews; ++i) {
        EXPECT_EQ(neighbours[static_cast<std::size_t>(i)].size(), 4U) << i;
        for (const int other : neighbours[static_cast<std::size_t>(i)])
            EXPECT_LE(std::abs(other - i), 4) << i;
    }
}

TEST(InverseDepthRange, HoldsTheScenePointsWithRoomToSpare) {
    DepthScene scene = arc(3, 5.0, 6.0);
    for (int i = 0; i < 100; ++i) {
        ScenePoint point;
        point.position_in_world = scene.views[0].cam_from_world.rotation.conjugate() *
                                  Eigen::Vector3d(0, 0, -1 + 0.02 * i);  // Depth 4 to 5.98.
        scene.points.push_back(point);
    }
    const auto range = inverse_depth_range(scene, 0);
    ASSERT_TRUE(range.has_value());
    EXPECT_LT(range->far, 1 / 8.0);
    EXPECT_GT(range->near, 1 / 3.0);
    EXPECT_EQ(range->far, 0);
}

/// A wall of a thousand points at depth 5 before the first view of an arc.
DepthScene wall_of_points() {
    DepthScene scene = arc(3, 5.0, 6.0);
    for (int i = 0; i < 1000; ++i) {
        ScenePoint point;
        point.position_in_world = {0.06 * (i % 40) - 1.2, 0.06 * (i / 40) - 0.75, 0};
        scene.points.push_back(point);
    }
    return scene;
}

/// Seen by the first view at this depth, so far aside of its axis on its picture of unit depth.
void add_point(DepthScene& scene, double depth, double aside) {
    ScenePoint point;
    point.position_in_world =
        inverse(scene.views[0].cam_from_world) * (depth * Eigen::Vector3d(aside, 0.1, 1));
    scene.points.push_back(point);
}

TEST(InverseDepthRange, HoldsAThingThatHasFewPointsBesideEachOther) {
    DepthScene scene = wall_of_points();
    const double without = inverse_depth_range(scene, 0)->near;
    EXPECT_LT(without, 1 / 2.0);
    for (int i = 0; i < 6; ++i) add_point(scene, 1.5 + 0.02 * i, 0.2 + 0.002 * i);
    EXPECT_GT(inverse_depth_range(scene, 0)->near, 1 / 1.5);
}

TEST(InverseDepthRange, IsTheSameOfAPhotographThatWasTakenUpright) {
    DepthScene scene = wall_of_points();
    // Beside each other by a tenth of the longer side, not of the shorter.
    for (int i = 0; i < 6; ++i) add_point(scene, 1.5 + 0.02 * i, 0.2 + 0.032 * i);
    DepthScene turned = scene;
    for (DepthView& view : turned.views) {
        const Eigen::Quaterniond quarter(
            Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()));
        view.cam_from_world = Rigid3{quarter, Eigen::Vector3d::Zero()} * view.cam_from_world;
        const Eigen::Vector2d focal = focal_length_px(view.camera);
        ASSERT_EQ(focal.x(), focal.y());
        view.camera = pinhole_camera(view.camera.height_px, view.camera.width_px, focal.x());
    }
    const double near = inverse_depth_range(scene, 0)->near;
    EXPECT_GT(near, 1 / 1.7);
    EXPECT_NEAR(inverse_depth_range(turned, 0)->near, near, 1e-9);
}

TEST(InverseDepthRange, LeavesOutAsManyStrayPoints) {
    DepthScene scene = wall_of_points();
    const double without = inverse_depth_range(scene, 0)->near;
    for (int i = 0; i < 6; ++i) add_point(scene, 0.4 * std::pow(1.3, i), 0.2);
    EXPECT_NEAR(inverse_depth_range(scene, 0)->near, without, 0.02 * without)
        << "beside each other, but each at a depth of its own";
    for (int i = 0; i < 4; ++i) add_point(scene, 1.5, 0.08 * i - 0.12);
    EXPECT_NEAR(inverse_depth_range(scene, 0)->near, without, 0.02 * without)
        << "at one depth, but all over the picture";
}

TEST(InverseDepthRange, WithoutPointsHoldsWhatTheCamerasLookAt) {
    const DepthScene scene = arc(8, 5.0, 10.0);
    EXPECT_LT((*convergence_point(scene)).norm(), 1e-9);
    const auto range = inverse_depth_range(scene, 3);
    ASSERT_TRUE(range.has_value());
    EXPECT_EQ(range->far, 0);
    EXPECT_GT(range->near, 1 / 2.5);
}

TEST(InverseDepthRange, WithoutPointsIsThatOfOnePhotographAPlaceWhereBurstsWereTaken) {
    DepthScene bursts = arc(24, 5.0, 2.5);
    for (DepthView& view : bursts.views) {  // Parallel: nothing but the cameras' distance tells.
        const Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
        view.cam_from_world = looking_ahead_from(centre);
    }
    const DepthScene singles = bursts;
    for (const DepthView& single : singles.views) {
        for (const double aside : {1e-4, 2e-4}) {
            DepthView again = single;
            again.cam_from_world.translation += Eigen::Vector3d(aside, 0, 0);
            bursts.views.push_back(again);
        }
    }
    const double near = inverse_depth_range(singles, 3)->near;
    EXPECT_NEAR(inverse_depth_range(bursts, 3)->near, near, 0.01 * near);
}

TEST(InverseDepthRange, IsTheSameInAnyUnit) {
    const auto metres = inverse_depth_range(arc(8, 5.0, 10.0), 3);
    const auto micrometres = inverse_depth_range(arc(8, 5.0e6, 10.0), 3);
    EXPECT_NEAR(micrometres->near * 1e6, metres->near, 1e-9);
}

TEST(InverseDepthRange, IsUnknownWhenAllCamerasStandInOnePlace) {
    DepthScene scene = arc(6, 0.0, 10.0);
    EXPECT_FALSE(inverse_depth_range(scene, 0).has_value());
}

}  // namespace
}  // namespace lumi
