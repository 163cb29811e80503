#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <string>

#include "calib/capture/degrees.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

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

}  // namespace
}  // namespace lumi
