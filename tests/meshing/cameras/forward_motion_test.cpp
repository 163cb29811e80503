#include "meshing/cameras/forward_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "calib/capture/degrees.h"
#include "calib/work/error.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

/// Cameras on the z axis that sway beside it by `sway`, all looking `angle_deg` past it.
std::vector<OpticalAxis> walk(int count, double step, double sway, double angle_deg) {
    const double angle = angle_deg * kRadiansPerDegree;
    std::vector<OpticalAxis> axes;
    for (int i = 0; i < count; ++i) {
        OpticalAxis axis;
        axis.view_index = i;
        axis.centre_in_world = {sway * std::cos(1.7 * i), sway * std::sin(1.7 * i), step * i};
        axis.direction_in_world = {std::sin(angle), 0, std::cos(angle)};
        axes.push_back(axis);
    }
    return axes;
}

CameraMesh walk_mesh() { return forward_mesh(walk(5, 0.5, 0.05, 0), {0, 0, 6}); }

TEST(ForwardMotion, IsFoundUpToAFifthOfSwayAndThirtyDegrees) {
    // 0.1 beside a way of 9 steps of 0.3: sigmas of 0.07 and 0.86.
    const auto straight = forward_motion(walk(10, 0.3, 0.1, 0));
    ASSERT_TRUE(straight.has_value());
    EXPECT_NEAR(straight->sway_share, 0.082, 0.02);
    EXPECT_LT(straight->angle_deg, 5);
    EXPECT_TRUE(forward_motion(walk(10, 0.3, 0.1, 25)).has_value());
    EXPECT_FALSE(forward_motion(walk(10, 0.3, 0.1, 36)).has_value());
    EXPECT_FALSE(forward_motion(walk(10, 0.3, 0.5, 0)).has_value());
}

TEST(ForwardMotion, IsWalkedBackwardsToo) {
    EXPECT_TRUE(forward_motion(walk(10, -0.3, 0.1, 0)).has_value());
    const CameraMesh mesh = forward_mesh(walk(10, -0.3, 0.1, 0), {0, 0, 6});
    EXPECT_EQ(mesh.vertices.front().view_index, 9);
}

TEST(ForwardMotion, IsNoneOfOneCameraOrOfCamerasThatLookAllAround) {
    EXPECT_FALSE(forward_motion(walk(1, 1, 0, 0)).has_value());
    EXPECT_FALSE(forward_motion(walk(4, 0, 0, 0)).has_value());
    std::vector<OpticalAxis> looking_around = walk(8, 0.3, 0, 0);
    for (int i = 0; i < 8; ++i)
        looking_around[static_cast<std::size_t>(i)].direction_in_world = {std::sin(0.8 * i), 0,
                                                                          std::cos(0.8 * i)};
    EXPECT_FALSE(forward_motion(looking_around).has_value());
}

TEST(ForwardMesh, BlendsTheTwoCamerasThatTheEyeStandsBetween) {
    const CameraMesh mesh = forward_mesh(walk(5, 0.5, 0, 0), {0, 0, 6});
    // 0.8 along the way, wherever beside it: 0.3 from camera 1, 0.2 from camera 2.
    for (const Eigen::Vector3d& eye : Points{{0, 0, 0.8}, {0.4, -0.2, 0.8}, {-3, 2, 0.8}}) {
        const auto weights = weights_by_view(weights_of_eye(mesh, eye), 5);
        EXPECT_NEAR(weights[1], 0.4, 1e-12);
        EXPECT_NEAR(weights[2], 0.6, 1e-12);
    }
    EXPECT_EQ(weights_by_view(weights_of_eye(mesh, {0.1, 0, -3}), 5)[0], 1);
    EXPECT_EQ(weights_by_view(weights_of_eye(mesh, {0.1, 0, 2.5}), 5)[4], 1);
}

TEST(ForwardMesh, GivesACameraItsOwnPicture) {
    // Of the long walk, the way leads past some cameras in another order than the line of sight.
    for (const CameraMesh& mesh :
         {walk_mesh(), forward_mesh(walk(300, 0.01, 0.3, 12), {0, 0, 6})}) {
        const std::size_t cameras = mesh.vertices.size();
        for (const CameraMesh::Vertex& camera : mesh.vertices) {
            const auto weights =
                weights_by_view(weights_of_eye(mesh, camera.position_in_world), cameras);
            EXPECT_NEAR(weights[static_cast<std::size_t>(camera.view_index)], 1, 1e-12);
        }
    }
}

TEST(ForwardMesh, WeighsContinuouslyAndTheSameInAllDirections) {
    const CameraMesh mesh = walk_mesh();
    std::mt19937 random(3);
    constexpr int kSteps = 4000;
    for (int path = 0; path < 20; ++path) {
        const Eigen::Vector3d from = 2 * random_direction(random) + Eigen::Vector3d(0, 0, 1);
        const Eigen::Vector3d to = 2 * random_direction(random) + Eigen::Vector3d(0, 0, 1);
        std::vector<double> last;
        for (int step = 0; step <= kSteps; ++step) {
            const Eigen::Vector3d eye = from + step * (to - from) / kSteps;
            const auto ray = weights_of_ray(mesh, eye, random_direction(random));
            ASSERT_TRUE(ray.has_value());
            const auto weights = weights_by_view(*ray, 5);
            double sum = 0;
            for (std::size_t view = 0; view < 5; ++view) {
                sum += weights[view];
                // A step of at most 1e-3 on cameras that stand 0.4 and more apart.
                if (last.empty()) continue;
                EXPECT_LT(std::abs(weights[view] - last[view]), 4e-3);
            }
            EXPECT_NEAR(sum, 1, 1e-12);
            last = weights;
        }
    }
}

Capture approach() {
    Points centres;
    for (int i = 0; i < 8; ++i)
        centres.emplace_back(0.02 * std::cos(1.7 * i), 0.02 * std::sin(1.7 * i), -4.0 + 0.45 * i);
    std::mt19937 random(1);
    return capture_of(centres, Eigen::Vector3d::Zero(),
                      points_in_ball(300, Eigen::Vector3d::Zero(), 0.4, random));
}

TEST(ForwardMesh, OfAnApproachHoldsAllCamerasAndNoCloseUps) {
    const Capture capture = approach();
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    EXPECT_EQ(built.mesh.construction, MeshConstruction::kForward) << built.evidence.explanation;
    EXPECT_EQ(built.evidence.cameras_kept, 8);
    EXPECT_TRUE(built.mesh.shells.empty());
    EXPECT_TRUE(built.mesh.faces.empty());
    for (int i = 0; i < 8; ++i)
        EXPECT_EQ(built.mesh.vertices[static_cast<std::size_t>(i)].view_index, i);
}

TEST(ForwardMesh, IsNotThePapersHull) {
    const Capture capture = approach();
    CameraMeshOptions options;
    options.shape = "convex";
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), options);
    EXPECT_NE(built.mesh.construction, MeshConstruction::kForward) << built.evidence.explanation;
}

TEST(ForwardMesh, LinksEachCameraWithThoseBeforeAndBehindIt) {
    const auto neighbours = neighbouring_views(walk_mesh(), 5);
    EXPECT_EQ(neighbours[0], std::set<int>{1});
    EXPECT_EQ(neighbours[2], (std::set<int>{1, 3}));
    EXPECT_EQ(neighbours[4], std::set<int>{3});
}

/// As an untrusted package may have them.
TEST(ForwardMesh, WeighsNumbersThatOverflowFinitely) {
    CameraMesh mesh = walk_mesh();
    for (CameraMesh::Vertex& camera : mesh.vertices) camera.position_in_world *= 1e308;
    for (const double far : {0.0, 1e308, std::numeric_limits<double>::quiet_NaN()}) {
        const RayWeights weights = weights_of_eye(mesh, Eigen::Vector3d::Constant(far));
        double sum = 0;
        for (const double weight : weights.weights) sum += weight;
        EXPECT_NEAR(sum, 1, 1e-12);
    }
}

TEST(ForwardMesh, CanBeAskedForWhereAllLookOneWay) {
    CameraMeshOptions options;
    options.construction = "forward";
    const Points row{{-1, 0, -3}, {0, 0, -3}, {1, 0, -3}};
    const Capture before = capture_of(row, Eigen::Vector3d::Zero(), {});
    EXPECT_EQ(build_camera_mesh(before, all_views(before), options).mesh.construction,
              MeshConstruction::kForward);
    Points around;
    for (const Eigen::Vector3d& direction : sphere_directions(20, -1))
        around.push_back(3 * direction);
    const Capture all_around = capture_of(around, Eigen::Vector3d::Zero(), {});
    EXPECT_THROW((void)build_camera_mesh(all_around, all_views(all_around), options), Error);
}

TEST(ForwardMesh, IsRefusedWithFaces) {
    CameraMesh mesh = walk_mesh();
    EXPECT_NO_THROW(validate(mesh, 5, "here"));
    mesh.faces.push_back({0, 1, 2});
    EXPECT_THROW(validate(mesh, 5, "here"), Error);
}

}  // namespace
}  // namespace lumi
