#include "render/faces/off_cameras.h"

#include <gtest/gtest.h>

#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

TEST(OffCameras, LeavesAnEyeThatIsAtNoCamera) {
    const Lumigraph lumigraph = ball_in_sky();
    const Eye eye =
        eye_at(centre_in_world(lumigraph.views[2].cam_from_world) + Eigen::Vector3d(1e-4, 0, 0),
               {0, 0, 0}, pinhole_camera(64, 48, 60));
    EXPECT_EQ(off_cameras(lumigraph.mesh, eye).cam_from_world.translation,
              eye.cam_from_world.translation);
}

TEST(OffCameras, TakesAnEyeThatIsAtACameraALittleBehindIt) {
    const Lumigraph lumigraph = ball_in_sky();
    const Eigen::Vector3d camera = centre_in_world(lumigraph.views[2].cam_from_world);
    for (const Eigen::Vector3d& aside :
         {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1e-7, -1e-7, 0)}) {
        const Eye eye = eye_at(camera + aside, {0.3, 0.1, 0}, pinhole_camera(64, 48, 60));
        const Eye moved = off_cameras(lumigraph.mesh, eye);
        const Eigen::Vector3d from_centre = camera - lumigraph.mesh.scene_centre_in_world;
        EXPECT_LT((centre_in_world(moved.cam_from_world) - camera - 1e-6 * from_centre).norm(),
                  1e-9);
        EXPECT_EQ(moved.cam_from_world.rotation.coeffs(), eye.cam_from_world.rotation.coeffs());
        EXPECT_EQ(moved.camera, eye.camera);
    }
}

}  // namespace
}  // namespace lumi
