#include "meshing/depth_models/plane_depth.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

/// Points on the plane of inverse depth 0.4 + 0.0005 x - 0.0003 y, some of them wrong.
DepthView view_of_plane(int points, int wrong) {
    DepthView view;
    view.camera = small_camera();
    std::mt19937 random(3);
    for (int i = 0; i < points; ++i) {
        const Eigen::Vector2d pixel(static_cast<int>(random() % 240) + 0.5,
                                    static_cast<int>(random() % 180) + 0.5);
        const double plane = 0.4 + 0.0005 * pixel.x() - 0.0003 * pixel.y();
        view.points.push_back({pixel, i < wrong ? 3.0 * plane : plane});
    }
    return view;
}

TEST(PlaneDepth, IsTheMedianOfThePoints) {
    DepthView view;
    view.camera = small_camera();
    for (const double inverse_depth : {0.1, 0.2, 9.0}) {
        view.points.push_back({{10, 10}, inverse_depth});
    }
    const DepthMap map = plane_depth(view);
    for (const float value : map.inverse_depth.pixels()) ASSERT_EQ(value, 0.2F);
}

TEST(PlaneDepth, WithoutPointsIsTheMiddleOfTheRange) {
    DepthView view;
    view.camera = small_camera();
    view.range = {0.2, 0.6};
    EXPECT_FLOAT_EQ(slanted_plane_depth(view).inverse_depth(7, 9), 0.4F);
}

TEST(PlaneDepth, ASlantedPlaneIsFoundAmongAThirdOfWrongPoints) {
    const DepthMap map = slanted_plane_depth(view_of_plane(120, 40));
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 240; ++x) {
            const double plane = 0.4 + 0.0005 * (x + 0.5) - 0.0003 * (y + 0.5);
            ASSERT_NEAR(map.inverse_depth(x, y), plane, 1e-4) << x << " " << y;
        }
    }
}

TEST(PlaneDepth, BeyondItsHorizonAPlaneIsInfinitelyFar) {
    DepthView view;
    view.camera = small_camera();
    for (int i = 0; i < 40; ++i) {
        const Eigen::Vector2d pixel(6.0 * i + 0.5, 100.0 + 13 * i % 80);
        view.points.push_back({pixel, 0.01 * (pixel.y() - 90)});
    }
    const DepthMap map = slanted_plane_depth(view);
    EXPECT_EQ(map.inverse_depth(120, 20), 0.0F);
    EXPECT_NEAR(map.inverse_depth(120, 139), 0.01 * 49.5, 1e-3);
}

}  // namespace
}  // namespace lumi
