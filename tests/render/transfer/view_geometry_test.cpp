#include "render/transfer/view_geometry.h"

#include <gtest/gtest.h>

#include "render/transfer/scene_plane.h"
#include "render/view_choice/depth_view_choice.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

TEST(ScenePlane, PassesThroughTheCentreAndFacesTheEye) {
    Lumigraph lumigraph;
    lumigraph.mesh.scene_centre_in_world = {0.5, -0.2, 5};
    const Eye eye = eye_at({1, 0.3, -1}, {0.4, 0.9, 4}, pinhole_camera(80, 60, 70));
    const Eigen::Vector3d line = scene_plane_inverse_depth(lumigraph, eye);
    const Eigen::Vector3d centre_in_eye = eye.cam_from_world * Eigen::Vector3d(0.5, -0.2, 5);
    for (int i = 0; i < 20; ++i) {
        const Eigen::Vector2d pixel(4 * i, 60 - 3 * i);
        const Eigen::Vector3d point = unproject(eye.camera, pixel) / line.dot(pixel.homogeneous());
        EXPECT_NEAR((point - centre_in_eye).dot(centre_in_eye), 0, 1e-9);
    }
}

TEST(ViewGeometry, TellsHowMuchLessUncertainASurfaceIsFromFarAway) {
    const Eigen::Vector3d scene_centre(0, 0, 4);
    const std::vector<ViewGeometry> views{
        {{0, 0, 0}, 100, 1}, {{4, 0, 4}, 100, 1}, {{0, -4, 4}, 100, 1}};
    const auto scale = [&](double depth) {
        return inverse_depth_in_eye(views, scene_centre, {0, 0, 4 - depth});
    };
    for (const double depth : {1.0, 2.0, 4.0, 9.0, 30.0}) {
        // The derivative of the eye's inverse depth by the cameras', of which both are functions of
        // where the surface is.
        const double step = 1e-5;
        const double in_eye = 1 / (depth - step) - 1 / (depth + step);
        const double in_views = 1 / (4 - step) - 1 / (4 + step);
        EXPECT_NEAR(scale(depth), in_eye / in_views, 1e-6 * scale(depth)) << depth;
    }
    EXPECT_DOUBLE_EQ(scale(0.3), 16);
    EXPECT_DOUBLE_EQ(scale(0), 16);
}

TEST(ViewGeometry, TakesTheMedianDistanceToNeighbours) {
    Lumigraph lumigraph;
    for (int i = 0; i < 4; ++i) {
        const Eye eye = eye_at({1.0 * i * i, 0, 0}, {1.0 * i * i, 0, 1}, pinhole_camera(8, 8, 10));
        lumigraph.views.push_back({"", eye.camera, eye.cam_from_world, 1, {}, {}});
        lumigraph.mesh.vertices.push_back({centre_in_world(eye.cam_from_world), i});
    }
    lumigraph.mesh.faces = {{0, 1, 2}, {1, 3, 2}};
    const auto geometries = view_geometries(lumigraph);
    EXPECT_NEAR(geometries[0].baseline, 4, 1e-12);  // 1 and 4 away
    EXPECT_NEAR(geometries[1].baseline, 3, 1e-12);  // 1, 3 and 8 away
    EXPECT_NEAR(disparity_px_per_inverse_depth(geometries[1], {1, 0.5, 0}), 5, 1e-12);
    EXPECT_NEAR(disparity_px_per_inverse_depth(geometries[1], {1, 50, 0}), 30, 1e-12);
    EXPECT_NEAR(disparity_px_per_inverse_depth(geometries[1], {1, 0, 0}), 0, 1e-12);
}

TEST(ViewGeometry, TakesNoBaselineFromCamerasAtOnePlace) {
    Lumigraph lumigraph;
    lumigraph.near_depth = 1;
    lumigraph.far_depth = 3;
    for (const double x : {0.0, 1e-9, 2e-9, 0.5}) {
        const Eye eye = eye_at({x, 0, 0}, {x, 0, 1}, pinhole_camera(8, 8, 10));
        lumigraph.views.push_back({"", eye.camera, eye.cam_from_world, 1, {}, {}});
        const auto index = static_cast<int>(lumigraph.mesh.vertices.size());
        lumigraph.mesh.vertices.push_back({centre_in_world(eye.cam_from_world), index});
    }
    lumigraph.mesh.faces = {{0, 1, 2}, {1, 3, 2}};
    const auto geometries = view_geometries(lumigraph);
    EXPECT_NEAR(geometries[0].baseline, 0.15, 1e-12);  // 0.1 of the middle depth, 1.5.
    EXPECT_NEAR(geometries[1].baseline, 0.5, 1e-6);    // That of the only one elsewhere.
}

TEST(DepthViewChoice, PutsTheViewThatStandsThereFirst) {
    const Lumigraph lumigraph = ball_in_sky();
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        const LumigraphView& view = lumigraph.views[i];
        const auto chosen = choose_depth_views(lumigraph, {view.camera, view.cam_from_world}, 4);
        ASSERT_EQ(chosen.size(), 4U);
        EXPECT_EQ(chosen.front(), static_cast<int>(i));
    }
}

// The first view is the nearest. Of the two others, which stand in one place, one has a photograph
// so wide that it also shows what stands before the eye.
TEST(DepthViewChoice, TakesViewsThatSeeWhatStandsBeforeTheScenePlane) {
    Lumigraph lumigraph;
    const auto add = [&](double x, double focal_px) {
        const Eye eye = eye_at({x, 0, 0}, {0, 0, 10}, pinhole_camera(64, 64, focal_px));
        lumigraph.views.push_back({"", eye.camera, eye.cam_from_world, 1, {}, {}});
    };
    add(0.9, 60);
    add(-1, 60);
    add(-1, 20);
    lumigraph.mesh.scene_centre_in_world = {0, 0, 10};
    lumigraph.near_depth = 1;
    lumigraph.far_depth = 12;
    const Eye eye = eye_at({0, 0, 0}, {0, 0, 10}, pinhole_camera(64, 64, 90));
    EXPECT_EQ(choose_depth_views(lumigraph, eye, 2), (std::vector<int>{0, 2}));
    lumigraph.near_depth = 9;
    EXPECT_EQ(choose_depth_views(lumigraph, eye, 2), (std::vector<int>{0, 1}));
}

// The first view is the eye's own, the second stands close to it and shows the same, the third far
// aside, but shows all that the eye sees.
TEST(DepthViewChoice, PrefersNearerViewsToThoseThatShowALittleMore) {
    const Eye eye = eye_at({0, 0, 0}, {0, 0, 10}, pinhole_camera(64, 64, 60));
    const auto chosen = [&](double focal_px) {
        Lumigraph lumigraph;
        const auto add = [&](double x, double of_view_px) {
            const Eye view = eye_at({x, 0, 0}, {0, 0, 10}, pinhole_camera(64, 64, of_view_px));
            lumigraph.views.push_back({"", view.camera, view.cam_from_world, 1, {}, {}});
        };
        add(0, focal_px);
        add(0.2, focal_px);
        add(3, 30);
        lumigraph.mesh.scene_centre_in_world = {0, 0, 10};
        lumigraph.near_depth = 9;
        lumigraph.far_depth = 12;
        return choose_depth_views(lumigraph, eye, 2);
    };
    EXPECT_EQ(chosen(80), (std::vector<int>{0, 1})) << "they show more than half of it";
    EXPECT_EQ(chosen(100), (std::vector<int>{0, 2})) << "they show a third of it";
}

TEST(DepthViewChoice, LeavesOutViewsThatLookElsewhere) {
    Lumigraph lumigraph;
    for (const double side : {-1.0, 1.0}) {
        const Eye eye = eye_at({side, 0, 0}, {5 * side, 0, 0}, pinhole_camera(64, 48, 60));
        lumigraph.views.push_back({"", eye.camera, eye.cam_from_world, 1, {}, {}});
    }
    lumigraph.mesh.scene_centre_in_world = {5, 0, 0};
    const Eye eye = eye_at({0.8, 0.1, 0}, {5, 0, 0}, pinhole_camera(64, 48, 60));
    EXPECT_EQ(choose_depth_views(lumigraph, eye, 4), (std::vector<int>{1}));
}

}  // namespace
}  // namespace lumi
