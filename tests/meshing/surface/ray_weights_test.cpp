#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "calib/work/error.h"
#include "meshing/surface/camera_mesh.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

/// An octahedron around the origin: vertices +x -x +y -y +z -z are views 0 to 5.
CameraMesh octahedron() {
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kClosed;
    for (int axis = 0; axis < 3; ++axis) {
        mesh.vertices.push_back({Eigen::Vector3d::Unit(axis), 2 * axis});
        mesh.vertices.push_back({-Eigen::Vector3d::Unit(axis), 2 * axis + 1});
    }
    mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    return mesh;
}

TEST(RayWeights, OfAnEyeOutsideAreThoseOfTheFaceTowardsIt) {
    const Eigen::Vector3d target(0.05, -0.02, 0.03);
    const Eigen::Vector3d eye(3, 2, 4);
    const auto weights = weights_of_ray(octahedron(), eye, target - eye);
    ASSERT_TRUE(weights.has_value());
    EXPECT_EQ(weights->face_index, 0);

    // Closed form: the face lies in x + y + z = 1, and its barycentric coordinates are x, y, z.
    const double t = (1 - eye.sum()) / (target - eye).sum();
    const Eigen::Vector3d crossing = eye + t * (target - eye);
    for (int corner = 0; corner < 3; ++corner) {
        EXPECT_NEAR(weights->weights[static_cast<std::size_t>(corner)], crossing[corner], 1e-14);
        EXPECT_EQ(weights->view_indices[static_cast<std::size_t>(corner)], 2 * corner);
    }
}

TEST(RayWeights, OfAnEyeInsideAreThoseOfTheFaceBehindIt) {
    const auto weights = weights_of_ray(octahedron(), {0.01, 0.02, 0.03}, {-1, -1.1, -1.2});
    ASSERT_TRUE(weights.has_value());
    EXPECT_EQ(weights->face_index, 0);
}

TEST(RayWeights, AtACameraAreExactlyItself) {
    const CameraMesh mesh = octahedron();
    std::mt19937 random(1);
    for (const CameraMesh::Vertex& camera : mesh.vertices) {
        for (const Eigen::Vector3d& target :
             points_in_ball(50, Eigen::Vector3d::Zero(), 0.5, random)) {
            const auto weights =
                weights_of_ray(mesh, camera.position_in_world, target - camera.position_in_world);
            ASSERT_TRUE(weights.has_value());
            const auto by_view = weights_by_view(*weights, 6);
            EXPECT_EQ(by_view[static_cast<std::size_t>(camera.view_index)], 1.0);
        }
    }
}

TEST(RayWeights, OfSeveralEnteringFacesAreThoseOfTheLast) {
    // Two triangles one behind the other, both facing an eye at z = +5 that looks along -z.
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kOpen;
    for (const double z : {1.0, 0.0}) {
        const int view = z > 0.5 ? 0 : 1;
        mesh.vertices.push_back({{-1, -1, z}, view});
        mesh.vertices.push_back({{1, -1, z}, view});
        mesh.vertices.push_back({{0, 1, z}, view});
    }
    const Eigen::Vector3d back = -Eigen::Vector3d::UnitZ();
    for (const auto& faces : {std::vector<CameraMesh::Face>{{0, 1, 2}, {3, 4, 5}},
                              std::vector<CameraMesh::Face>{{3, 4, 5}, {0, 1, 2}}}) {
        mesh.faces = faces;
        for (const double eye_z : {5.0, 0.5, -3.0}) {
            const auto weights = weights_of_ray(mesh, {0, 0, eye_z}, back);
            ASSERT_TRUE(weights.has_value());
            EXPECT_EQ(weights->view_indices[0], 1);
        }
    }
    // Seen from behind, both are left, not entered.
    EXPECT_FALSE(weights_of_ray(mesh, {0, 0, -5}, -back).has_value());
}

TEST(RayWeights, OfASingleCameraAreItself) {
    CameraMesh mesh;
    mesh.vertices.push_back({Eigen::Vector3d(1, 2, 3), 7});
    const auto weights = weights_of_ray(mesh, {0, 0, 0}, {0, 1, 0});
    ASSERT_TRUE(weights.has_value());
    EXPECT_EQ(weights->view_indices[0], 7);
    EXPECT_EQ(weights->weights[0], 1.0);
}

TEST(CameraMesh, NamesOfConstructionsAreReadBack) {
    for (const MeshConstruction construction :
         {MeshConstruction::kClosed, MeshConstruction::kOpen, MeshConstruction::kLine,
          MeshConstruction::kPair, MeshConstruction::kNearest, MeshConstruction::kSingle}) {
        EXPECT_EQ(mesh_construction_named(name_of(construction)), construction);
    }
    EXPECT_FALSE(mesh_construction_named("auto").has_value());
}

TEST(CameraMesh, RefusesIndicesOutOfRangeAndNumbersThatAreNotFinite) {
    EXPECT_NO_THROW(validate(octahedron(), 6, "here"));
    EXPECT_THROW(validate(octahedron(), 5, "here"), Error);
    CameraMesh mesh = octahedron();
    mesh.faces[3][1] = 6;
    EXPECT_THROW(validate(mesh, 6, "here"), Error);
    mesh = octahedron();
    mesh.vertices[2].position_in_world.y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(validate(mesh, 6, "here"), Error);
}

}  // namespace
}  // namespace lumi
