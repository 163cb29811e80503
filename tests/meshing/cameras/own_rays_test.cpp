#include "meshing/cameras/own_rays.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "calib/capture/rigid3.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

/// Somebody in the middle of a room of radius 4: cameras at about 0.4 from the middle, off by
/// `roughness` of that, which look outwards.
Capture outward_ball(int count, double roughness, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> off(1 - roughness, 1 + roughness);
    Points centres;
    for (int i = 0; i < count; ++i) centres.push_back(0.4 * off(random) * random_direction(random));
    Points walls;
    for (int i = 0; i < 600; ++i) walls.push_back(4 * random_direction(random));
    Capture capture = capture_of(centres, Eigen::Vector3d::Zero(), walls);
    for (View& view : capture.views) {
        const Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
        const Eigen::Vector3d axis = centre.normalized() + 0.15 * random_direction(random);
        view.cam_from_world.rotation = turn_between(axis, Eigen::Vector3d::UnitZ());
        view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
    }
    return capture;
}

double weight_on_own_axis(const CameraMesh& mesh, const Capture& capture, int view_index) {
    const Rigid3& pose = capture.views[static_cast<std::size_t>(view_index)].cam_from_world;
    const auto weights = weights_of_ray(mesh, centre_in_world(pose), optical_axis_in_world(pose));
    return weights ? weights_by_view(*weights,
                                     capture.views.size())[static_cast<std::size_t>(view_index)]
                   : 0.0;
}

TEST(OutwardBall, HasEveryCameraAsAVertexAndOnItsOwnAxisAlone) {
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        for (const int count : {12, 30, 60}) {
            const Capture capture = outward_ball(count, 0.1, seed);
            const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
            ASSERT_EQ(built.mesh.construction, MeshConstruction::kClosed);
            EXPECT_EQ(built.evidence.cameras_kept, count);
            for (int view = 0; view < count; ++view) {
                EXPECT_NEAR(weight_on_own_axis(built.mesh, capture, view), 1, 1e-9)
                    << seed << ", view " << view << " of " << count;
            }
        }
    }
}

/// On a ball all of their rays are theirs. A camera behind the others' mesh sees through it at a
/// slant, and the evidence says how much that comes to.
TEST(OutwardBall, LeavesRaysOfCamerasInItsHollowsToOthersAndSaysSo) {
    double last = 1.0;
    for (const double roughness : {0.0, 0.3, 0.6}) {
        const Capture capture = outward_ball(60, roughness, 5);
        const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
        EXPECT_EQ(built.evidence.cameras_kept, 60);
        const double share = built.evidence.own_ray_share;
        if (roughness == 0) {
            EXPECT_NEAR(share, 1, 1e-9);
        } else {
            EXPECT_LT(share, last);
            EXPECT_GT(share, 0.8);
        }
        EXPECT_EQ(built.evidence.explanation.find("own rays") != std::string::npos, roughness > 0)
            << built.evidence.explanation;
        last = share;
    }
}

TEST(OwnRayShare, IsOneOfAKernelThatHoldsTheSceneAndTheShareOfAMovedCamera) {
    std::mt19937 random(6);
    const Capture capture = capture_of(sphere_directions(40, -1), Eigen::Vector3d::Zero(),
                                       points_in_ball(200, Eigen::Vector3d::Zero(), 0.3, random));
    BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    Points scene;
    for (const ScenePoint& point : capture.points) scene.push_back(point.position_in_world);
    EXPECT_NEAR(own_ray_share(capture, built.mesh, scene), 1, 1e-12);
    EXPECT_EQ(own_ray_share(capture, built.mesh, {}), 1);
    // A camera's vertex at its neighbour's side: its rays are no longer its own.
    for (CameraMesh::Vertex& vertex : built.mesh.vertices) {
        if (vertex.view_index == 7) vertex.position_in_world *= 1.2;
    }
    const double share = own_ray_share(capture, built.mesh, scene);
    EXPECT_LT(share, 1 - 1e-4);
    EXPECT_GT(share, 1 - 1.0 / 40);
}

}  // namespace
}  // namespace lumi
