#include "meshing/cameras/forward_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "calib/capture/degrees.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/cameras/preconditions.h"
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

Capture approach() {
    Points centres;
    for (int i = 0; i < 8; ++i)
        centres.emplace_back(0.02 * std::cos(1.7 * i), 0.02 * std::sin(1.7 * i), -4.0 + 0.45 * i);
    std::mt19937 random(1);
    return capture_of(centres, Eigen::Vector3d::Zero(),
                      points_in_ball(300, Eigen::Vector3d::Zero(), 0.4, random));
}

TEST(MeshWithoutFaces, OfAnApproachHoldsAllCamerasAndNoCloseUps) {
    const Capture capture = approach();
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    EXPECT_EQ(built.mesh.construction, MeshConstruction::kNearest) << built.evidence.explanation;
    EXPECT_EQ(built.evidence.cameras_kept, 8);
    EXPECT_TRUE(built.mesh.shells.empty());
    EXPECT_TRUE(built.mesh.faces.empty());
    for (int i = 0; i < 8; ++i)
        EXPECT_EQ(built.mesh.vertices[static_cast<std::size_t>(i)].view_index, i);
}

TEST(MeshWithoutFaces, IsNotThePapersHull) {
    const Capture capture = approach();
    CameraMeshOptions options;
    options.shape = "convex";
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), options);
    EXPECT_NE(built.mesh.construction, MeshConstruction::kNearest) << built.evidence.explanation;
}

TEST(MeshWithoutFaces, CanBeAskedFor) {
    CameraMeshOptions options;
    options.construction = "nearest";
    Points around;
    for (const Eigen::Vector3d& direction : sphere_directions(20, -1))
        around.push_back(3 * direction);
    const Capture all_around = capture_of(around, Eigen::Vector3d::Zero(), {});
    const CameraMesh mesh = build_camera_mesh(all_around, all_views(all_around), options).mesh;
    EXPECT_EQ(mesh.construction, MeshConstruction::kNearest);
    ASSERT_EQ(mesh.vertices.size(), 20U);
    for (const CameraMesh::Vertex& camera : mesh.vertices) {
        const Eigen::Vector3d inwards = -camera.position_in_world.normalized();
        EXPECT_LT((camera.line_of_sight_in_world - inwards).norm(), 1e-9);
    }
}

/// A walk along one corridor and, round a corner, another; points on the walls of both.
Capture walk_round_a_corner() {
    Capture capture;
    capture.cameras.push_back(pinhole_camera(640, 480, 400));
    const auto photograph = [&](const Eigen::Vector3d& centre, double turn) {
        View view;
        view.name = std::to_string(capture.views.size());
        view.cam_from_world.rotation =
            Eigen::Quaterniond(Eigen::AngleAxisd(-turn, Eigen::Vector3d::UnitY()));
        view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
        capture.views.push_back(view);
    };
    for (int i = 0; i < 14; ++i) photograph({0.02 * (i % 3), 0, 0.5 * i}, 0);
    for (int i = 1; i < 6; ++i) {
        const double angle = 15 * i * kRadiansPerDegree;
        photograph({2 - 2 * std::cos(angle), 0.02, 7 + 2 * std::sin(angle)}, angle);
    }
    for (int i = 0; i < 12; ++i)
        photograph({2 + 0.5 * i, 0.02 * (i % 2), 9}, 90 * kRadiansPerDegree);
    const auto add = [&](double x, double y, double z) {
        ScenePoint point;
        point.position_in_world = {x, y, z};
        for (std::size_t i = 0; i < capture.views.size(); ++i) {
            const auto pixel = project(capture.cameras.front(),
                                       capture.views[i].cam_from_world * point.position_in_world);
            if (pixel && is_inside(capture.cameras.front(), *pixel))
                point.track.push_back({static_cast<int>(i), *pixel});
        }
        if (point.track.size() >= 2) capture.points.push_back(point);
    };
    for (double y = -1; y <= 1; y += 0.25) {
        for (double along = 0; along < 10; along += 0.25) {
            add(-1.4, y, along);
            if (along < 7) add(1.4, y, along);
            add(along, y, 10.4);
            if (along > 1.5) add(along, y, 7.6);
        }
    }
    return capture;
}

TEST(MeshWithoutFaces, IsTakenWhereNoSurfaceLiesBetweenCamerasAndScene) {
    const Capture capture = walk_round_a_corner();
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    EXPECT_EQ(built.mesh.construction, MeshConstruction::kNearest) << built.evidence.explanation;
    EXPECT_EQ(built.evidence.cameras_kept, static_cast<int>(capture.views.size()));
    EXPECT_TRUE(built.mesh.faces.empty());
    EXPECT_TRUE(built.mesh.shells.empty());
    EXPECT_NE(built.evidence.explanation.find("face what a surface"), std::string::npos)
        << built.evidence.explanation;
    CameraMeshOptions options;
    options.construction = "open";
    EXPECT_EQ(build_camera_mesh(capture, all_views(capture), options).mesh.construction,
              MeshConstruction::kOpen);
    options = {};
    options.shape = "convex";
    EXPECT_NE(build_camera_mesh(capture, all_views(capture), options).mesh.construction,
              MeshConstruction::kNearest);
}

TEST(Preconditions, AskWhoFacesTheMiddleOrWhatLiesOppositeOfIt) {
    // On a ring, looking in, along it, and out.
    for (const double turn_deg : {0.0, 90.0, 180.0}) {
        Capture capture;
        capture.cameras.push_back(pinhole_camera(640, 480, 500));
        for (int i = 0; i < 12; ++i) {
            View view;
            view.name = std::to_string(i);
            view.cam_from_world.rotation = Eigen::AngleAxisd(
                (30 * i + turn_deg) * kRadiansPerDegree, Eigen::Vector3d::UnitY());
            const double at = 30 * i * kRadiansPerDegree;
            const Eigen::Vector3d centre(3 * std::sin(at), 0, -3 * std::cos(at));
            view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
            capture.views.push_back(view);
        }
        const auto axes = optical_axes(capture, all_views(capture));
        EXPECT_EQ(share_that_faces(capture, axes, {0, 0, 0}, false), turn_deg == 0 ? 1 : 0);
        EXPECT_EQ(share_that_faces(capture, axes, {0, 0, 0}, true), turn_deg == 180 ? 1 : 0);
    }
}

TEST(Preconditions, AreMetByMostOfTheSceneAndOfTheCameras) {
    EXPECT_FALSE(why_no_surface({}).has_value());
    EXPECT_FALSE(why_no_surface({0.98, 0.9}).has_value());
    EXPECT_TRUE(why_no_surface({0.54, 1.0}).has_value());
    EXPECT_TRUE(why_no_surface({1.0, 0.52}).has_value());
}

}  // namespace
}  // namespace lumi
