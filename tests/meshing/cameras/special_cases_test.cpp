#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <set>

#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/cameras/camera_star.h"
#include "meshing/cameras/construction.h"
#include "meshing/cameras/convex_mesh.h"
#include "meshing/cameras/kernel.h"
#include "meshing/cameras/slide.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

/// The place on a camera plane whose barycentric weights these are.
Eigen::Vector3d weighted_place(const RayWeights& weights, const Points& centres) {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        place += weights.weights[i] * centres[static_cast<std::size_t>(weights.view_indices[i])];
    }
    return place;
}

/// Cameras on a plane that share one image plane: the two-plane slab. (s, t) is where the ray meets
/// the camera plane, and (u, v) where it meets the image plane, in every camera the same.
TEST(TwoPlaneSlab, IsWhatCamerasOnAPlaneSpan) {
    Points centres;
    for (int i = 0; i < 25; ++i) centres.emplace_back(i % 5, i / 5, 0.0);
    std::mt19937 random(1);
    Capture capture = capture_of(centres, {2, 2, 1e7}, points_in_ball(300, {2, 2, 6}, 2, random));
    for (std::size_t i = 0; i < centres.size(); ++i) {
        capture.views[i].cam_from_world = {Eigen::Quaterniond::Identity(), -centres[i]};
    }
    for (const std::string shape : {"star", "convex"}) {
        const BuiltCameraMesh built =
            build_camera_mesh(capture, all_views(capture), {.shape = shape});
        ASSERT_EQ(built.mesh.construction, MeshConstruction::kOpen);
        EXPECT_EQ(built.evidence.cameras_kept, 25) << shape;
        std::uniform_real_distribution<double> across(0.05, 3.95);
        for (const Eigen::Vector3d& target : points_in_ball(2000, {2, 2, 6}, 2, random)) {
            const Eigen::Vector3d on_cameras(across(random), across(random), 0);
            const auto weights = weights_of_ray(built.mesh, on_cameras - 2 * (target - on_cameras),
                                                target - on_cameras);
            ASSERT_TRUE(weights.has_value());
            EXPECT_LT((weighted_place(*weights, centres) - on_cameras).norm(), 1e-10);
            // The three cameras are corners of the cell that (s, t) lies in.
            for (std::size_t i = 0; i < 3; ++i) {
                if (weights->weights[i] < 1e-9) continue;
                const Eigen::Vector3d& corner =
                    centres[static_cast<std::size_t>(weights->view_indices[i])];
                EXPECT_LT((corner - on_cameras).cwiseAbs().maxCoeff(), 1.0);
            }
            // On the plane z = 1, which all cameras share as their image plane, one place (u, v).
            const Eigen::Vector3d on_images = on_cameras + (target - on_cameras) / target.z();
            for (const View& view : capture.views) {
                const Eigen::Vector3d in_view = view.cam_from_world * on_images;
                EXPECT_NEAR(in_view.z(), 1, 1e-12);
                EXPECT_LT((in_view.head<2>() + centre_in_world(view.cam_from_world).head<2>() -
                           on_images.head<2>())
                              .norm(),
                          1e-12);
            }
        }
    }
}

/// Cameras on the faces of a cube: six slabs. Each ray is blended on the side that it enters
/// through, at its place there.
TEST(SixSlabs, AreWhatCamerasOnACubeSpan) {
    Points centres;
    constexpr int kSide = 5;
    for (int i = 0; i < kSide; ++i) {
        for (int j = 0; j < kSide; ++j) {
            for (int k = 0; k < kSide; ++k) {
                const Eigen::Vector3d place =
                    Eigen::Vector3d(i, j, k) / 2 - Eigen::Vector3d::Ones();
                if (place.cwiseAbs().maxCoeff() > 0.99) centres.push_back(place);
            }
        }
    }
    std::mt19937 random(2);
    const Capture capture = capture_of(centres, Eigen::Vector3d::Zero(),
                                       points_in_ball(300, Eigen::Vector3d::Zero(), 0.4, random));
    for (const std::string shape : {"star", "convex"}) {
        const BuiltCameraMesh built =
            build_camera_mesh(capture, all_views(capture), {.shape = shape});
        ASSERT_EQ(built.mesh.construction, MeshConstruction::kClosed);
        EXPECT_EQ(built.evidence.cameras_kept, static_cast<int>(centres.size())) << shape;
        int compared = 0;
        for (const Eigen::Vector3d& target :
             points_in_ball(3000, Eigen::Vector3d::Zero(), 0.4, random)) {
            const Eigen::Vector3d away = random_direction(random);
            double enters_at = 1e9;
            for (int axis = 0; axis < 3; ++axis) {
                const double wall = away[axis] > 0 ? 1.0 : -1.0;
                enters_at = std::min(enters_at, (wall - target[axis]) / away[axis]);
            }
            const Eigen::Vector3d place = target + enters_at * away;
            const auto weights = weights_of_ray(built.mesh, target + 5 * away, -away);
            ASSERT_TRUE(weights.has_value());
            EXPECT_LT((weighted_place(*weights, centres) - place).norm(), 1e-6) << shape;
            ++compared;
        }
        EXPECT_EQ(compared, 3000);
    }
}

TEST(ConvexMesh, IsTheHullOfTheCamerasAndLosesThoseWithin) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> distance(0.75, 1.25);
    Points centres;
    for (const Eigen::Vector3d& direction : sphere_directions(48, -1)) {
        centres.push_back(distance(random) * direction);
    }
    const Capture capture = capture_of(centres, Eigen::Vector3d::Zero(),
                                       points_in_ball(300, Eigen::Vector3d::Zero(), 0.4, random));
    const BuiltCameraMesh star = build_camera_mesh(capture, all_views(capture), {});
    const BuiltCameraMesh convex =
        build_camera_mesh(capture, all_views(capture), {.shape = "convex"});
    EXPECT_EQ(star.evidence.cameras_kept, 48);
    EXPECT_LT(convex.evidence.cameras_kept, 40);
    EXPECT_NE(convex.evidence.explanation.find("within the convex hull"), std::string::npos);
    // No camera beyond any face.
    for (const FacePlane& plane : face_planes(convex.mesh)) {
        for (const Eigen::Vector3d& centre : centres) {
            EXPECT_LE(plane.outward_normal.dot(centre - convex.mesh.scene_centre_in_world),
                      plane.distance + 1e-6);
        }
    }
    // Where every ray is entered once, whatever it meets within.
    for (const Eigen::Vector3d& point : points_in_ball(500, Eigen::Vector3d::Zero(), 0.6, random)) {
        EXPECT_EQ(entering_faces(convex.mesh, point, random_direction(random)), 1);
    }
}

TEST(ConvexMesh, MeasuresHowFarTheOthersWouldHaveToBePushed) {
    // An octahedron of unit size and one camera half-way to the middle of a face, which lies
    // 1 / sqrt(3) from the centre.
    Points centres;
    for (int axis = 0; axis < 3; ++axis) {
        centres.push_back(Eigen::Vector3d::Unit(axis));
        centres.push_back(-Eigen::Vector3d::Unit(axis));
    }
    centres.push_back(0.5 / std::sqrt(3.0) * Eigen::Vector3d::Ones().normalized());
    std::vector<OpticalAxis> axes;
    for (const Eigen::Vector3d& centre : centres) {
        axes.push_back({static_cast<int>(axes.size()), centre, -centre.normalized(), 1});
    }
    const ConvexShape shape =
        convex_shape(camera_star(axes, Eigen::Vector3d::Zero()), std::nullopt);
    EXPECT_EQ(shape.faces.size(), 8U);
    EXPECT_EQ(shape.on_hull, (std::vector<char>{1, 1, 1, 1, 1, 1, 0}));
    EXPECT_NEAR(shape.largest_push_share, 1.0, 1e-6);
    EXPECT_NEAR(shape.rms_push_share, 1.0 / std::sqrt(7.0), 1e-6);
}

TEST(ConvexMesh, OfAnArcLosesTheCameraThatStandsFarIn) {
    Points centres;
    for (int i = 0; i < 9; ++i) {
        const double azimuth = 0.2 * (i - 4);
        const double distance = i == 3 ? 2.5 : 3.0;
        centres.emplace_back(distance * std::cos(azimuth), distance * std::sin(azimuth), 0.0);
    }
    std::mt19937 random(4);
    const Capture capture = capture_of(centres, Eigen::Vector3d::Zero(),
                                       points_in_ball(300, Eigen::Vector3d::Zero(), 0.5, random));
    const BuiltCameraMesh convex =
        build_camera_mesh(capture, all_views(capture), {.shape = "convex"});
    ASSERT_EQ(convex.mesh.construction, MeshConstruction::kLine);
    std::set<int> kept;
    for (const auto& vertex : convex.mesh.vertices) kept.insert(vertex.view_index);
    EXPECT_EQ(kept, (std::set<int>{0, 1, 2, 4, 5, 6, 7, 8}));
}

}  // namespace
}  // namespace lumi
