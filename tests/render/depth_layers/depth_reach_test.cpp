#include "render/depth_layers/depth_reach.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

/// At the origin, looking along z.
LumigraphView some_view() {
    LumigraphView view;
    view.camera = pinhole_camera(64, 48, 60);
    return view;
}

/// Surfaces from `near_depth` to `far_depth` all over the photograph.
Eigen::AlignedBox3d box_between(double near_depth, double far_depth) {
    return {Eigen::Vector3d(0, 0, 1 / far_depth), Eigen::Vector3d(64, 48, 1 / near_depth)};
}

TEST(DepthReach, OfAMeshWithoutVerticesIsNothing) {
    EXPECT_EQ(depth_reach(some_view(), box_of(DepthMesh{}), {some_view().camera, {}}), 0);
}

TEST(DepthReach, OfAnEyeBehindAViewIsThatOfTheNearestSurface) {
    const Eye eye = eye_at({0, 0, -7}, {0, 0, 1}, pinhole_camera(80, 60, 700));
    EXPECT_NEAR(depth_reach(some_view(), box_between(2, 1e9), eye), 1.0 / 9, 1e-12);
}

TEST(DepthReach, BoundsWhatAnyPointOfTheMeshHas) {
    DepthMesh mesh;
    mesh.vertices = {{3, 4, 0.5F}, {60, 10, 0.05F}, {20, 40, 0.2F}, {30, 30, 0.0F}};
    const Eye eye = eye_at({0.4, -0.3, -2}, {0.1, 0.2, 3}, pinhole_camera(80, 60, 70));
    const double reach = depth_reach(some_view(), box_of(mesh), eye);
    EXPECT_LT(reach, 0.5) << "the eye is farther away than the view";
    std::mt19937 random(2);
    std::uniform_real_distribution<double> share(0, 1);
    for (int i = 0; i < 1000; ++i) {
        Eigen::Vector3d at = Eigen::Vector3d::Zero();
        double sum = 0;
        for (const Eigen::Vector3f& vertex : mesh.vertices) {
            const double weight = share(random);
            at += weight * vertex.cast<double>();
            sum += weight;
        }
        at /= sum;
        const Eigen::Vector3d in_world = unproject(some_view().camera, at.head<2>()) / at.z();
        EXPECT_LE(1 / (eye.cam_from_world * in_world).z(), reach);
    }
}

TEST(DepthReach, HasNoBoundWhereSurfacesMayPassTheEye) {
    const Eye within = eye_at({0, 0, 3}, {0, 0, 9}, pinhole_camera(80, 60, 70));
    EXPECT_TRUE(std::isinf(depth_reach(some_view(), box_between(2, 8), within)));
    EXPECT_LT(depth_reach(some_view(), box_between(4, 8), within), 1.01);
    // All lies behind it.
    const Eye beyond = eye_at({0, 0, 9}, {0, 0, 19}, pinhole_camera(80, 60, 70));
    EXPECT_EQ(depth_reach(some_view(), box_between(2, 8), beyond), 0);
}

}  // namespace
}  // namespace lumi
