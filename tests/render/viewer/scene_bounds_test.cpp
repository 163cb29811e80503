#include "render/viewer/scene_bounds.h"

#include <gtest/gtest.h>

#include "tests/render/lumigraph/tiny_package.h"

namespace lumi {
namespace {

/// One camera at the origin looking along z at a wall at depth 5; every pixel is confident.
Lumigraph wall() {
    Lumigraph lumigraph;
    LumigraphView view;
    view.name = "wall.png";
    view.camera = pinhole_camera(200, 100, 100.0);
    view.photograph = ColorImage(200, 100);
    view.depth = {FloatImage(100, 50, 0.2F), GrayImage(100, 50, 255)};
    lumigraph.views.push_back(view);
    lumigraph.mesh.vertices.push_back({Eigen::Vector3d::Zero(), 0});
    lumigraph.mesh.scene_centre_in_world = {0, 0, 3};
    return lumigraph;
}

TEST(SceneBounds, OfAWallLieOnTheWall) {
    const SceneBounds bounds = bounds_of(wall());
    // The wall is 10 x 5 at z = 5 about the axis; the grid is coarse.
    EXPECT_LT((bounds.centre_in_world - Eigen::Vector3d(0, 0, 5)).norm(), 0.5);
    EXPECT_GT(bounds.radius, 4.0);
    EXPECT_LT(bounds.radius, 5.6) << "half the diagonal";
}

TEST(SceneBounds, DoNotFollowAFewWildDepths) {
    Lumigraph lumigraph = wall();
    for (int x = 0; x < 5; ++x) {
        for (int y = 0; y < 50; ++y) lumigraph.views[0].depth.inverse_depth(x, y) = 1e-6F;
    }
    EXPECT_LT(bounds_of(lumigraph).radius, 7.0);
}

TEST(SceneBounds, LookAtConfidentDepthOnly) {
    for (const std::uint8_t confidence : {std::uint8_t{0}, kFilledBeforeBackground}) {
        Lumigraph lumigraph = wall();
        for (int x = 0; x < 100; ++x) {
            for (int y = 0; y < 30; ++y) {
                lumigraph.views[0].depth.inverse_depth(x, y) = 1e-3F;
                lumigraph.views[0].depth.confidence(x, y) = confidence;
            }
        }
        EXPECT_NEAR(bounds_of(lumigraph).centre_in_world.z(), 5.0, 1e-6);
    }
}

TEST(SceneBounds, WithoutDepthAreHalfAsWideAsTheCamerasStandAway) {
    Lumigraph lumigraph = wall();
    lumigraph.views[0].depth = {};
    EXPECT_EQ(bounds_of(lumigraph).centre_in_world, Eigen::Vector3d(0, 0, 3));
    EXPECT_DOUBLE_EQ(bounds_of(lumigraph).radius, 1.5);
}

TEST(PointInTheMiddle, LiesInThePlaneOfTheSceneCentreWhereDepthIsNotKnown) {
    Lumigraph lumigraph = wall();
    lumigraph.views[0].depth = {};
    lumigraph.mesh.scene_centre_in_world = {2, 1, 3};
    EXPECT_LT(
        (point_in_the_middle(lumigraph, lumigraph.views[0]) - Eigen::Vector3d(0, 0, 3)).norm(),
        1e-12);
}

}  // namespace
}  // namespace lumi
