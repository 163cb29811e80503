#include "render/paths/pose_around.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/paths/path_past_border.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

const Eigen::Vector3d kPoint(0.3, -0.2, 4);

Rigid3 pose_at(const Eigen::Vector3d& centre, const Eigen::Vector3d& target) {
    return eye_at(centre, target, pinhole_camera(64, 48, 60)).cam_from_world;
}

double apart(const Rigid3& a, const Rigid3& b) {
    return (centre_in_world(a) - centre_in_world(b)).norm() +
           a.rotation.angularDistance(b.rotation);
}

TEST(PoseAround, BeginsAtOnePoseAndEndsAtTheOther) {
    const Rigid3 from = pose_at({0, 0, 0}, {0.5, 0.1, 4});
    const Rigid3 to = pose_at({2, 1, 7}, {0, 0, 3});
    EXPECT_LT(apart(pose_around(kPoint, from, to, 0), from), 1e-9);
    EXPECT_LT(apart(pose_around(kPoint, from, to, 1), to), 1e-9);
}

TEST(PoseAround, LooksAtThePointAllTheWayAroundIt) {
    // From opposite sides: straight on it would pass through the point.
    const Rigid3 from = pose_at(kPoint + Eigen::Vector3d(0, 0, -4), kPoint);
    const Rigid3 to = pose_at(kPoint + Eigen::Vector3d(0.1, 0, 2), kPoint);
    for (int i = 0; i <= 20; ++i) {
        const double share = i / 20.0;
        const Rigid3 pose = pose_around(kPoint, from, to, share);
        const Eigen::Vector3d in_camera = pose * kPoint;
        EXPECT_NEAR(in_camera.norm(), 4 - share * (4 - std::hypot(0.1, 2)), 1e-9) << share;
        EXPECT_GT(in_camera.z() / in_camera.norm(), 1 - 1e-9) << share;
    }
}

TEST(PoseAround, RunsStraightFromThePointItself) {
    const Rigid3 from = pose_at(kPoint, {0, 0, 9});
    const Rigid3 to = pose_at(kPoint + Eigen::Vector3d(1, 0, 0), {0, 0, 9});
    const Rigid3 half = pose_around(kPoint, from, to, 0.5);
    EXPECT_LT((centre_in_world(half) - kPoint - Eigen::Vector3d(0.5, 0, 0)).norm(), 1e-9);
}

// Cameras all around: the way from beyond the border back to the first leads past the scene.
TEST(PathPastBorder, KeepsOutOfTheMiddleOfTheScene) {
    const Lumigraph lumigraph = ball_in_sky();
    double nearest = 1e9;
    double nearest_camera = 1e9;
    for (const Eye& eye : path_past_border(lumigraph, 200, 64, 48))
        nearest = std::min(
            nearest,
            (centre_in_world(eye.cam_from_world) - lumigraph.mesh.scene_centre_in_world).norm());
    for (const LumigraphView& view : lumigraph.views)
        nearest_camera = std::min(
            nearest_camera,
            (centre_in_world(view.cam_from_world) - lumigraph.mesh.scene_centre_in_world).norm());
    EXPECT_GT(nearest, 0.5 * nearest_camera);
}

}  // namespace
}  // namespace lumi
