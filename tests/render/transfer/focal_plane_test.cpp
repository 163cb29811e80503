#include "render/transfer/focal_plane.h"

#include <gtest/gtest.h>

#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

TEST(FocalPlane, MovesWithTheEyeAndIsEverywhereAsFarAlongItsAxis) {
    const Eye eye = eye_at({0.3, -0.2, 1}, {1, 2, 4}, pinhole_camera(64, 48, 60));
    const Eigen::Vector3d line = focal_plane_inverse_depth({.depth = 2.5}, eye);
    for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(0, 0), Eigen::Vector2d(64, 13)})
        EXPECT_NEAR(line.dot(pixel.homogeneous()), 1 / 2.5, 1e-12);
}

TEST(FocalPlane, StandsFixedAcrossACamerasAxisForEveryEye) {
    const Eye across = eye_at({0, 1, -2}, {0.4, 0, 3}, pinhole_camera(64, 48, 60));
    const FocalPlane plane{.depth = 4, .cam_from_world = across.cam_from_world};
    const Rigid3 world_from_camera = inverse(across.cam_from_world);
    const Eye before = eye_at({1, 0, 0}, {0, 0, 3}, pinhole_camera(80, 60, 70));
    const Eye behind = eye_at({0.5, 0.2, 9}, {0, 0, 3}, pinhole_camera(80, 60, 70));
    for (const Eye& eye : {across, before, behind}) {
        const Eigen::Vector3d line = focal_plane_inverse_depth(plane, eye);
        for (const auto& on_plane : {Eigen::Vector3d(0, 0, 4), Eigen::Vector3d(0.7, -0.4, 4)}) {
            const Eigen::Vector3d in_eye = eye.cam_from_world * (world_from_camera * on_plane);
            const auto pixel = project(eye.camera, in_eye);
            ASSERT_TRUE(pixel.has_value());
            EXPECT_NEAR(line.dot(pixel->homogeneous()), 1 / in_eye.z(), 1e-12);
        }
    }
}

TEST(FocalPlane, OfAnEyeThatStandsInItIsInfinitelyFar) {
    const Eye eye = eye_at({0, 0, 0}, {0, 0, 1}, pinhole_camera(64, 48, 60));
    Rigid3 behind;
    behind.translation = {0, 0, 4};
    EXPECT_EQ(focal_plane_inverse_depth({.depth = 4, .cam_from_world = behind}, eye),
              Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace lumi
