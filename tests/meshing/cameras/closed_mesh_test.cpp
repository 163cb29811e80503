#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/cameras/kernel.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

constexpr double kSceneRadius = 0.4;

/// Cameras all around at distances 0.75 to 1.25, which is far from a convex arrangement.
Capture rough_sphere(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> distance(0.75, 1.25);
    Points centres;
    for (const Eigen::Vector3d& direction : sphere_directions(48, -1)) {
        centres.push_back(distance(random) * direction);
    }
    return capture_of(centres, Eigen::Vector3d::Zero(),
                      points_in_ball(500, Eigen::Vector3d::Zero(), kSceneRadius, random));
}

class ClosedMesh : public testing::TestWithParam<unsigned> {
 protected:
    ClosedMesh()
        : capture_(rough_sphere(GetParam())),
          built_(build_camera_mesh(capture_, all_views(capture_), {})) {}

    Capture capture_;
    BuiltCameraMesh built_;
};

TEST_P(ClosedMesh, KeepsEveryCameraAtItsTruePlace) {
    EXPECT_EQ(built_.mesh.construction, MeshConstruction::kClosed);
    EXPECT_EQ(built_.evidence.cameras_kept, 48);
    EXPECT_EQ(built_.mesh.vertices.size(), 48U);
    for (const CameraMesh::Vertex& vertex : built_.mesh.vertices) {
        const View& view = capture_.views[static_cast<std::size_t>(vertex.view_index)];
        EXPECT_LT((vertex.position_in_world - centre_in_world(view.cam_from_world)).norm(), 1e-12);
    }
}

TEST_P(ClosedMesh, IsEnteredByEveryRayThroughTheSceneExactlyOnce) {
    ASSERT_GE(built_.evidence.kernel_radius_over_scene_radius, 1.0);
    ASSERT_EQ(built_.evidence.faces_with_scene_outside, 0);
    const double radius = kernel_radius(face_planes(built_.mesh));
    ASSERT_GT(radius, 0.3);
    std::mt19937 random(GetParam() + 100);
    int once = 0;
    for (const Eigen::Vector3d& point :
         points_in_ball(100'000, built_.mesh.scene_centre_in_world, radius, random)) {
        once += entering_faces(built_.mesh, point, random_direction(random)) == 1 ? 1 : 0;
    }
    EXPECT_EQ(once, 100'000);
}

TEST_P(ClosedMesh, WeighsARayTheSameFromEveryEyeOnIt) {
    std::mt19937 random(GetParam() + 200);
    std::uniform_real_distribution<double> along(-4, 4);
    for (const Eigen::Vector3d& point :
         points_in_ball(5'000, Eigen::Vector3d::Zero(), 0.3, random)) {
        const Eigen::Vector3d direction = random_direction(random);
        const auto one = weights_of_ray(built_.mesh, point + along(random) * direction, direction);
        const auto other =
            weights_of_ray(built_.mesh, point + along(random) * direction, 3.0 * direction);
        ASSERT_TRUE(one.has_value() && other.has_value());
        const auto by_view = weights_by_view(*one, 48);
        const auto by_view_again = weights_by_view(*other, 48);
        double sum = 0;
        for (std::size_t view = 0; view < by_view.size(); ++view) {
            EXPECT_NEAR(by_view[view], by_view_again[view], 1e-12);
            EXPECT_GE(by_view[view], 0);
            sum += by_view[view];
        }
        EXPECT_NEAR(sum, 1, 1e-14);
    }
}

TEST_P(ClosedMesh, GivesACameraItsOwnRays) {
    std::mt19937 random(GetParam() + 300);
    for (const CameraMesh::Vertex& vertex : built_.mesh.vertices) {
        for (const Eigen::Vector3d& point :
             points_in_ball(40, Eigen::Vector3d::Zero(), 0.3, random)) {
            const auto weights = weights_of_ray(built_.mesh, vertex.position_in_world,
                                                point - vertex.position_in_world);
            ASSERT_TRUE(weights.has_value());
            EXPECT_EQ(weights_by_view(*weights, 48)[static_cast<std::size_t>(vertex.view_index)],
                      1.0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ClosedMesh, testing::Values(1U, 2U, 3U));

TEST(ClosedMeshKernel, ReportsASceneThatReachesBeyondIt) {
    std::mt19937 random(5);
    Points centres;
    for (const Eigen::Vector3d& direction : sphere_directions(12, -1)) centres.push_back(direction);
    // The icosahedron-like hull of 12 cameras has an inner radius of about 0.75.
    const Capture capture = capture_of(centres, Eigen::Vector3d::Zero(),
                                       points_in_ball(2000, Eigen::Vector3d::Zero(), 0.97, random));
    const BuiltCameraMesh built =
        build_camera_mesh(capture, all_views(capture), {.construction = "closed", .repair = false});
    EXPECT_EQ(built.mesh.construction, MeshConstruction::kClosed);
    EXPECT_LT(built.evidence.kernel_radius_over_scene_radius, 1.0);
    EXPECT_GT(built.evidence.kernel_radius_over_scene_radius, 0.6);
}

TEST(ClosedMeshKernel, IsAskedForMostOfTheScene) {
    std::mt19937 random(5);
    Points centres;
    for (const Eigen::Vector3d& direction : sphere_directions(12, -1)) centres.push_back(direction);
    for (const bool reaches_beyond : {false, true}) {
        const Capture capture = capture_of(
            centres, Eigen::Vector3d::Zero(),
            points_in_ball(2000, Eigen::Vector3d::Zero(), reaches_beyond ? 0.97 : 0.7, random));
        const BuiltCameraMesh built =
            build_camera_mesh(capture, all_views(capture), {.repair = false});
        EXPECT_EQ(built.mesh.construction,
                  reaches_beyond ? MeshConstruction::kNearest : MeshConstruction::kClosed)
            << built.evidence.explanation;
        EXPECT_EQ(built.evidence.explanation.find("cross two faces of a mesh") != std::string::npos,
                  reaches_beyond)
            << built.evidence.explanation;
    }
}

TEST(Kernel, OfACubeHasItsClosedForm) {
    CameraMesh mesh;
    mesh.scene_centre_in_world = {10, 0, 0};
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back({Eigen::Vector3d(10 + ((i & 1) != 0 ? 1 : -1),
                                                 (i & 2) != 0 ? 2 : -2, (i & 4) != 0 ? 3 : -3),
                                 i});
    }
    mesh.faces = {{1, 3, 5}, {0, 4, 2}, {2, 6, 3}, {0, 1, 4}, {4, 5, 6}, {0, 2, 1}};
    const auto planes = face_planes(mesh);
    EXPECT_DOUBLE_EQ(kernel_radius(planes), 1.0);
    EXPECT_DOUBLE_EQ(kernel_gauge(planes, {0.5, 0.5, 0.5}), 0.5);
    EXPECT_DOUBLE_EQ(kernel_gauge(planes, {0.5, 0, -6}), 2.0);
    EXPECT_DOUBLE_EQ(kernel_clearance(planes, {0.5, 0, -6}), -3.0);
}

}  // namespace
}  // namespace lumi
