#include "pipeline/evaluate/moved_eye.h"

#include <gtest/gtest.h>

#include "tests/calib/synthetic_capture.h"

namespace lumi {
namespace {

Lumigraph around_the_origin() {
    Lumigraph lumigraph;
    lumigraph.mesh.scene_centre_in_world = Eigen::Vector3d::Zero();
    lumigraph.near_depth = 1;
    lumigraph.far_depth = 9;
    return lumigraph;
}

Eye eye_at(const Eigen::Vector3d& place, const Eigen::Vector3d& target) {
    return {pinhole_camera(64, 48, 60), looking_at(place, target)};
}

TEST(MovedEye, ComesNearerToTheSceneOrGoesAwayByItsShareOfTheDistance) {
    const Eye eye = eye_at({0, 0, -6}, {0, 0, 0});
    const auto place_after = [&](double share) {
        return centre_in_world(moved_ahead(around_the_origin(), eye, share).cam_from_world);
    };
    EXPECT_TRUE(place_after(1.0 / 3).isApprox(Eigen::Vector3d(0, 0, -4), 1e-12));
    EXPECT_TRUE(place_after(-1.0 / 3).isApprox(Eigen::Vector3d(0, 0, -8), 1e-12));
    EXPECT_TRUE(place_after(0).isApprox(Eigen::Vector3d(0, 0, -6), 1e-12));
}

TEST(MovedEye, KeepsLookingWhereItLooked) {
    const Eye eye = eye_at({1, 0.5, -6}, {0.3, 0, 0});
    const Eye moved = moved_ahead(around_the_origin(), eye, 0.25);
    EXPECT_EQ(moved.cam_from_world.rotation.coeffs(), eye.cam_from_world.rotation.coeffs());
    const Eigen::Vector3d way =
        centre_in_world(moved.cam_from_world) - centre_in_world(eye.cam_from_world);
    EXPECT_GT(way.normalized().dot(optical_axis_in_world(eye.cam_from_world)), 1 - 1e-12);
}

TEST(MovedEye, StaysWhereItLooksAwayFromTheScene) {
    const Eye eye = eye_at({0, 0, -6}, {0, 0, -9});
    const Eye moved = moved_ahead(around_the_origin(), eye, 1.0 / 3);
    EXPECT_EQ(moved.cam_from_world.translation, eye.cam_from_world.translation);
}

}  // namespace
}  // namespace lumi
