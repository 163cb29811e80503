#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <set>

#include "meshing/cameras/border.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/cameras/kernel.h"
#include "meshing/cameras/thin_border.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

constexpr int kColumns = 5;
constexpr int kRows = 4;

/// A grid of cameras at x = 0 ... 4, y = 0 ... 3, z = 0 that look along +z, and a scene at z = 10.
Capture wall_capture() {
    std::mt19937 random(1);
    Points centres;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            centres.emplace_back(column, row, 0);
        }
    }
    return capture_of(centres, {2, 1.5, 1e4}, points_in_ball(400, {2, 1.5, 10}, 3, random));
}

Capture dome_capture(double least_z) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> distance(0.85, 1.15);
    Points centres;
    for (const Eigen::Vector3d& direction : sphere_directions(100, least_z)) {
        centres.push_back(distance(random) * direction);
    }
    return capture_of(centres, Eigen::Vector3d::Zero(),
                      points_in_ball(400, Eigen::Vector3d::Zero(), 0.35, random));
}

TEST(OpenMesh, OverAPlanarGridGivesThePlanarBarycentricCoordinates) {
    const Capture capture = wall_capture();
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    ASSERT_EQ(built.mesh.construction, MeshConstruction::kOpen);
    EXPECT_EQ(built.evidence.cameras_kept, kColumns * kRows);

    std::mt19937 random(3);
    std::uniform_real_distribution<double> across(0.01, kColumns - 1.01);
    std::uniform_real_distribution<double> down(0.01, kRows - 1.01);
    for (const Eigen::Vector3d& point : points_in_ball(5000, {2, 1.5, 10}, 3, random)) {
        const Eigen::Vector3d on_grid(across(random), down(random), 0);
        const Eigen::Vector3d direction = point - on_grid;
        const auto weights = weights_of_ray(built.mesh, on_grid - 0.7 * direction, direction);
        ASSERT_TRUE(weights.has_value());
        Eigen::Matrix3d corners;
        double largest_edge = 0;
        for (int i = 0; i < 3; ++i) {
            const int view = weights->view_indices[static_cast<std::size_t>(i)];
            corners.col(i) = Eigen::Vector3d(view % kColumns, view / kColumns, 1);
        }
        for (int i = 0; i < 3; ++i) {
            largest_edge =
                std::max(largest_edge, (corners.col(i) - corners.col((i + 1) % 3)).norm());
        }
        EXPECT_NEAR(largest_edge, std::sqrt(2.0), 1e-12);  // half a cell of the grid
        const Eigen::Vector3d barycentric =
            corners.inverse() * Eigen::Vector3d(on_grid.x(), on_grid.y(), 1);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(weights->weights[static_cast<std::size_t>(i)], barycentric[i], 1e-11);
        }
    }
}

TEST(OpenMesh, IsEnteredOnceByRaysFromAllOfTheOuterHalfSpace) {
    for (const Capture& capture : {wall_capture(), dome_capture(0.5), dome_capture(0.0)}) {
        const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
        ASSERT_EQ(built.mesh.construction, MeshConstruction::kOpen) << built.evidence.explanation;
        EXPECT_EQ(built.evidence.cameras_kept, built.evidence.cameras_total);
        ASSERT_GE(built.evidence.kernel_radius_over_scene_radius, 1.0)
            << built.evidence.explanation;

        // The cameras look back from the mean of their places.
        Eigen::Vector3d outward = Eigen::Vector3d::Zero();
        for (const View& view : capture.views) {
            outward -= optical_axis_in_world(view.cam_from_world);
        }
        outward.normalize();
        std::mt19937 random(4);
        constexpr double kLeastSine = 0.2;  // Steeper than 12 degrees to the border's plane.
        int tried = 0;
        for (const ScenePoint& point : capture.points) {
            for (int i = 0; i < 40; ++i) {
                const Eigen::Vector3d to_eye = random_direction(random);
                if (to_eye.dot(outward) < kLeastSine) continue;
                ++tried;
                EXPECT_EQ(entering_faces(built.mesh, point.position_in_world, -to_eye), 1);
            }
        }
        EXPECT_GT(tried, 5000);
    }
}

TEST(OpenMesh, BeyondItsBorderUsesBorderCamerasOnly) {
    const Capture capture = wall_capture();
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    for (const double y : {0.25, 1.5, 2.75}) {
        const Eigen::Vector3d eye(12, y, 0);
        const auto weights = weights_of_ray(built.mesh, eye, Eigen::Vector3d(2, 1.5, 10) - eye);
        ASSERT_TRUE(weights.has_value());
        for (std::size_t i = 0; i < 3; ++i) {
            if (weights->weights[i] > 0) {
                EXPECT_EQ(weights->view_indices[i] % kColumns, kColumns - 1);
            }
        }
    }
}

/// Random directions with a jagged border: from half a dome to far beyond the equator.
TEST(OpenMesh, DoesNotFoldAtAJaggedBorder) {
    int open = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        std::mt19937 random(seed);
        const double border_z = 0.6 - 0.03 * seed;
        Points centres;
        while (centres.size() < 40) {
            const Eigen::Vector3d direction = random_direction(random);
            const double wave = 0.2 * std::sin(3 * std::atan2(direction.y(), direction.x()));
            if (direction.z() > border_z + wave) centres.push_back(direction);
        }
        const Capture capture =
            capture_of(centres, Eigen::Vector3d::Zero(),
                       points_in_ball(100, Eigen::Vector3d::Zero(), 0.1, random));
        const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
        EXPECT_EQ(built.evidence.cameras_kept, 40);
        if (built.mesh.construction != MeshConstruction::kOpen) continue;
        ++open;
        const double radius = kernel_radius(face_planes(built.mesh));
        EXPECT_GT(radius, 0) << "seed " << seed;
        for (const Eigen::Vector3d& point :
             points_in_ball(300, built.mesh.scene_centre_in_world, radius, random)) {
            EXPECT_LE(entering_faces(built.mesh, point, random_direction(random)), 1);
        }
    }
    EXPECT_GT(open, 30);
}

/// A row of border cameras that a hand holds nearly in one line: the triangles between them and the
/// line have planes that point anywhere, and are no part of the surface.
TEST(OpenMesh, GivesEveryCameraOfAHandHeldGridItsOwnRaysHoweverWideTheScene) {
    for (const int side : {3, 4, 5}) {
        for (const double shake : {0.0, 0.005, 0.02}) {
            for (const double scene_radius : {0.5, 2.0, 2.6}) {
                std::mt19937 random(static_cast<unsigned>(side));
                Points centres;
                for (int i = 0; i < side * side; ++i) {
                    centres.push_back(Eigen::Vector3d(3, 0.1 * (i % side), 0.1 * (i / side)) +
                                      0.1 * shake * random_direction(random));
                }
                const Capture capture =
                    capture_of(centres, Eigen::Vector3d::Zero(),
                               points_in_ball(200, Eigen::Vector3d::Zero(), scene_radius, random));
                const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
                ASSERT_EQ(built.mesh.construction, MeshConstruction::kOpen);
                for (std::size_t camera = 0; camera < centres.size(); ++camera) {
                    for (const ScenePoint& point : capture.points) {
                        const auto weights = weights_of_ray(
                            built.mesh, centres[camera], point.position_in_world - centres[camera]);
                        ASSERT_TRUE(weights.has_value());
                        EXPECT_GE(weights_by_view(*weights, centres.size())[camera], 1 - 1e-9)
                            << side << " x " << side << ", shake " << shake << ", scene "
                            << scene_radius << ", camera " << camera;
                    }
                }
            }
        }
    }
}

TEST(Border, IsPeeledOfThinTrianglesWithoutLosingACamera) {
    // A square whose lower side sags towards the middle by little, and one camera in the middle.
    const Points cameras{{-1, -1, 3}, {0, -0.9, 3}, {1, -1, 3}, {1, 1, 3}, {-1, 1, 3}, {0, 0.2, 3}};
    Points directions;
    for (const Eigen::Vector3d& camera : cameras) directions.push_back(camera.normalized());
    auto faces = open_triangulation(directions, -Eigen::Vector3d::UnitZ());
    const std::size_t before = faces.size();
    peel_thin_border(directions, 0.3, faces);
    EXPECT_EQ(faces.size(), before - 1);
    std::set<int> cameras_on_faces;
    for (const auto& face : faces) cameras_on_faces.insert(face.begin(), face.end());
    EXPECT_EQ(cameras_on_faces.size(), cameras.size());
    const auto border = border_edges(faces);
    EXPECT_EQ(border.size(), 5U);
    EXPECT_TRUE(std::any_of(border.begin(), border.end(),
                            [](const auto& edge) { return edge[0] == 1 || edge[1] == 1; }));
}

/// Weights on both sides of every inner edge, skirts included, by rays 1e-7 apart.
TEST(OpenMesh, WeightsAreContinuousAcrossEveryEdge) {
    for (const Capture& capture : {wall_capture(), dome_capture(0.0)}) {
        const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
        const Eigen::Vector3d target = built.mesh.scene_centre_in_world;
        std::mt19937 random(5);
        int compared = 0;
        for (const CameraMesh::Face& face : built.mesh.faces) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const auto& from = built.mesh.vertices[static_cast<std::size_t>(face[corner])];
                const auto& to =
                    built.mesh.vertices[static_cast<std::size_t>(face[(corner + 1) % 3])];
                const Eigen::Vector3d on_edge =
                    0.7 * from.position_in_world + 0.3 * to.position_in_world;
                const Eigen::Vector3d aside = 1e-7 * random_direction(random);
                const auto one = weights_of_ray(built.mesh, on_edge + aside, target - on_edge);
                const auto other = weights_of_ray(built.mesh, on_edge - aside, target - on_edge);
                if (!one || !other) continue;  // the outermost edge of the skirt
                ++compared;
                const auto by_view = weights_by_view(*one, capture.views.size());
                const auto by_view_again = weights_by_view(*other, capture.views.size());
                for (std::size_t view = 0; view < by_view.size(); ++view) {
                    EXPECT_NEAR(by_view[view], by_view_again[view], 1e-4);
                }
            }
        }
        EXPECT_GT(compared, static_cast<int>(2 * built.mesh.faces.size()));
    }
}

}  // namespace
}  // namespace lumi
