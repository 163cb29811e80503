#include "meshing/cameras/stray_cameras.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "calib/capture/rigid3.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

Capture capture_around(const Points& centres) {
    std::mt19937 random(4);
    return capture_of(centres, Eigen::Vector3d::Zero(),
                      points_in_ball(400, Eigen::Vector3d::Zero(), 0.6, random));
}

/// Hand-held, about 3 from the scene.
Points ring(int count) {
    std::mt19937 random(5);
    Points centres;
    for (int i = 0; i < count; ++i) {
        const double azimuth = 2 * std::numbers::pi * i / count;
        centres.emplace_back(3 * std::cos(azimuth), 3 * std::sin(azimuth), 0.5);
        centres.back() += 0.03 * random_direction(random);
    }
    return centres;
}

std::vector<OpticalAxis> axes_over(const Points& centres) {
    const Capture capture = capture_around(centres);
    return optical_axes(capture, all_views(capture));
}

TEST(StrayCameras, AreFewThatStandMuchNearerOrFartherThanTheUsual) {
    Points centres = ring(30);
    EXPECT_EQ(without_strays(axes_over(centres)).size(), 30U);
    centres.emplace_back(10, 0, 5);
    centres.emplace_back(0.6, 0.6, 0.3);
    const auto others = without_strays(axes_over(centres));
    ASSERT_EQ(others.size(), 30U);
    EXPECT_EQ(others.back().view_index, 29);
    // More than a tenth are no strays.
    for (int i = 0; i < 3; ++i) centres.emplace_back(10, i, 5);
    EXPECT_EQ(without_strays(axes_over(centres)).size(), centres.size());
}

/// One step back for an overview does not cost the others the surface that they stand on.
TEST(StrayCameras, LeaveTheOthersTheirSurface) {
    for (const Eigen::Vector3d& stray : {Eigen::Vector3d(10, 0, 5), Eigen::Vector3d(100, 20, 50)}) {
        Points centres = ring(30);
        const BuiltCameraMesh alone =
            build_camera_mesh(capture_around(centres), all_views(capture_around(centres)), {});
        ASSERT_EQ(alone.mesh.construction, MeshConstruction::kLine);
        centres.push_back(stray);
        const Capture capture = capture_around(centres);
        const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
        EXPECT_EQ(built.mesh.construction, MeshConstruction::kLine) << built.evidence.explanation;
        EXPECT_EQ(built.evidence.cameras_total, 31);
        EXPECT_EQ(built.evidence.cameras_kept, 30);
        EXPECT_NE(built.evidence.explanation.find("left out"), std::string::npos)
            << built.evidence.explanation;
        for (const CameraMesh::Vertex& vertex : built.mesh.vertices)
            EXPECT_LT(vertex.view_index, 30);
    }
}

TEST(StrayCameras, AreVerticesLikeOthersWhereTheSurfaceHoldsThem) {
    Points centres;
    for (const Eigen::Vector3d& direction : sphere_directions(60, -1))
        centres.push_back(3 * direction);
    centres[20] *= 2.2;
    const Capture capture = capture_around(centres);
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    EXPECT_EQ(built.mesh.construction, MeshConstruction::kClosed) << built.evidence.explanation;
    EXPECT_EQ(built.evidence.cameras_kept, 60) << built.evidence.explanation;
}

TEST(StrayCameras, DoNotMakeASurfaceOfAWalk) {
    Points centres;
    for (int i = 0; i < 12; ++i) centres.emplace_back(3 + 0.4 * i, 0.1 * (i % 3), 0.1 * (i % 2));
    centres.emplace_back(40, 1, 0);
    const Capture capture = capture_around(centres);
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    EXPECT_EQ(built.mesh.construction, MeshConstruction::kNearest) << built.evidence.explanation;
    EXPECT_EQ(built.evidence.cameras_kept, 13);
}

}  // namespace
}  // namespace lumi
