#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <numeric>
#include <utility>

#include "calib/capture/degrees.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/cameras/line_strip.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

struct Row {
    const char* name;
    Points centres;  ///< In the order along the row; a ring's last is the first's neighbour.
    bool ring;
};

Points arc(int count, double from_deg, double to_deg, double height) {
    Points centres;
    for (int i = 0; i < count; ++i) {
        const double azimuth =
            (from_deg + (to_deg - from_deg) * i / (count - 1)) * kRadiansPerDegree;
        centres.emplace_back(4 * std::cos(azimuth), 4 * std::sin(azimuth), height);
    }
    return centres;
}

std::vector<Row> rows() {
    Points line;
    for (int i = 0; i < 7; ++i) line.emplace_back(4, 0.5 * (i - 3), 0);
    return {{"line", line, false},
            {"arc", arc(9, -60, 60, 0), false},
            {"long arc", arc(20, -140, 140, 0), false},
            {"ring", arc(16, 0, 337.5, 0), true},
            {"raised ring", arc(16, 0, 337.5, 2), true},
            {"pair", {{4, -1, 0}, {4, 1, 0}}, false}};
}

BuiltCameraMesh build_row(const Row& row) {
    std::mt19937 random(1);
    const Capture capture = capture_of(row.centres, Eigen::Vector3d::Zero(),
                                       points_in_ball(300, Eigen::Vector3d::Zero(), 1, random));
    return build_camera_mesh(capture, all_views(capture), {});
}

TEST(Strip, IsWhatRowsArcsAndRingsGet) {
    for (const Row& row : rows()) {
        const BuiltCameraMesh built = build_row(row);
        EXPECT_EQ(built.mesh.construction,
                  row.centres.size() == 2 ? MeshConstruction::kPair : MeshConstruction::kLine)
            << row.name << ": " << built.evidence.explanation;
        EXPECT_EQ(built.evidence.cameras_kept, static_cast<int>(row.centres.size())) << row.name;
        const std::size_t ends = row.ring ? 0 : 2;
        EXPECT_EQ(built.mesh.vertices.size(), 2 * (row.centres.size() + ends)) << row.name;
        EXPECT_GE(built.evidence.kernel_radius_over_scene_radius, 1.0) << row.name;
    }
}

/// The views in the order of the strip, from the first one onwards, in the direction of the second.
std::vector<int> order_along(const CameraMesh& mesh) {
    std::vector<int> order;
    for (const CameraMesh::Vertex& vertex : mesh.vertices) {
        if (order.empty() || order.back() != vertex.view_index) order.push_back(vertex.view_index);
    }
    if (order.size() > 1 && order.front() == order.back()) order.pop_back();
    std::rotate(order.begin(), std::find(order.begin(), order.end(), 0), order.end());
    if (order.size() > 2 && order[1] > order.back()) std::reverse(order.begin() + 1, order.end());
    return order;
}

TEST(Strip, OfARaisedRingIsTheSameWhetherItIsFoundOrAskedFor) {
    std::vector<int> around(16);
    std::iota(around.begin(), around.end(), 0);
    for (const double elevation_deg : {0.0, 15.0, 26.0, 40.0, 60.0}) {
        std::mt19937 random(1);
        const double height = 4 * std::tan(elevation_deg * kRadiansPerDegree);
        const Capture capture = capture_of(arc(16, 0, 337.5, height), Eigen::Vector3d::Zero(),
                                           points_in_ball(300, Eigen::Vector3d::Zero(), 1, random));
        const CameraMesh asked =
            build_camera_mesh(capture, all_views(capture), {.construction = "line"}).mesh;
        EXPECT_EQ(order_along(asked), around) << elevation_deg;
        if (elevation_deg > 44) continue;  // Higher up a surface serves better.
        const CameraMesh found = build_camera_mesh(capture, all_views(capture), {}).mesh;
        ASSERT_EQ(found.construction, MeshConstruction::kLine) << elevation_deg;
        EXPECT_EQ(order_along(found), around) << elevation_deg;
    }
}

/// So many cameras beside and above each other before the scene, 4 from its middle.
Points grid(int columns, int rows, double step_deg) {
    Points centres;
    for (int row = 0; row < rows; ++row) {
        const double elevation = (row - 0.5 * (rows - 1)) * step_deg * kRadiansPerDegree;
        for (int column = 0; column < columns; ++column) {
            const double azimuth = (column - 0.5 * (columns - 1)) * step_deg * kRadiansPerDegree;
            centres.push_back(4 * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                                  std::cos(elevation) * std::sin(azimuth),
                                                  std::sin(elevation)));
        }
    }
    return centres;
}

BuiltCameraMesh line_over(const Points& centres) {
    std::mt19937 random(1);
    const Capture capture = capture_of(centres, Eigen::Vector3d::Zero(),
                                       points_in_ball(300, Eigen::Vector3d::Zero(), 1, random));
    return build_camera_mesh(capture, all_views(capture), {.construction = "line"});
}

TEST(Strip, ThatIsAskedForOverAGridIsNotStretchedAlongTheLineOfSight) {
    for (const auto& [columns, rows] : {std::pair(2, 2), std::pair(3, 2), std::pair(4, 3),
                                        std::pair(5, 3), std::pair(4, 4), std::pair(6, 4)}) {
        for (const double step_deg : {4.0, 8.0, 15.0}) {
            const BuiltCameraMesh built = line_over(grid(columns, rows, step_deg));
            EXPECT_EQ(built.evidence.scene_share_in_kernel, 1.0)
                << columns << " times " << rows << " by " << step_deg << ": "
                << built.evidence.faces_with_scene_outside;
        }
    }
}

TEST(Strip, ThatIsAskedForOverARaisedRingOfFewCamerasGoesAround) {
    for (const auto& [count, elevation_deg] :
         {std::pair(3, 40.0), std::pair(4, 40.0), std::pair(4, 55.0), std::pair(5, 60.0)}) {
        const double height = 4 * std::tan(elevation_deg * kRadiansPerDegree);
        const BuiltCameraMesh built = line_over(arc(count, 0, 360.0 - 360.0 / count, height));
        EXPECT_EQ(built.mesh.vertices.size(), 2U * static_cast<std::size_t>(count))
            << count << " at " << elevation_deg;
        EXPECT_GE(built.evidence.kernel_radius_over_scene_radius, 1.0)
            << count << " at " << elevation_deg;
    }
}

/// s_i = det[C_i - X, v, n]; between neighbours with different signs w_i = |s_i+1| / (|s_i| +
/// |s_i+1|). Rays that meet the row from its cameras' side of the scene.
TEST(Strip, HasTheWeightsOfTheClosedForm) {
    for (const Row& row : rows()) {
        const BuiltCameraMesh built = build_row(row);
        std::mt19937 random(2);
        std::uniform_real_distribution<double> share(0, 1);
        std::uniform_real_distribution<double> height(-2, 2);
        const std::size_t count = row.centres.size();
        for (const Eigen::Vector3d& point :
             points_in_ball(2000, Eigen::Vector3d::Zero(), 0.9, random)) {
            const std::size_t first = random() % (row.ring ? count : count - 1);
            const Eigen::Vector3d& a = row.centres[first];
            const Eigen::Vector3d& b = row.centres[(first + 1) % count];
            const double t = share(random);
            const Eigen::Vector3d crossing =
                (1 - t) * a + t * b + height(random) * Eigen::Vector3d::UnitZ();
            const Eigen::Vector3d v = crossing - point;
            const double s_a = (a - point).dot(v.cross(Eigen::Vector3d::UnitZ()));
            const double s_b = (b - point).dot(v.cross(Eigen::Vector3d::UnitZ()));
            const double expected = std::abs(s_b) / (std::abs(s_a) + std::abs(s_b));

            const auto weights = weights_of_ray(built.mesh, point + 1.5 * v, -v);
            ASSERT_TRUE(weights.has_value()) << row.name;
            const auto by_view = weights_by_view(*weights, count);
            // The raised ring's plane normal is found to rounding, hence not exactly z.
            EXPECT_NEAR(by_view[first], expected, 1e-9) << row.name;
            EXPECT_NEAR(by_view[(first + 1) % count], 1 - expected, 1e-9) << row.name;
        }
    }
}

TEST(Strip, IsEnteredOnceByRaysThroughTheScene) {
    for (const Row& row : rows()) {
        const BuiltCameraMesh built = build_row(row);
        std::mt19937 random(3);
        int tried = 0;
        for (const Eigen::Vector3d& point :
             points_in_ball(3000, Eigen::Vector3d::Zero(), 0.9, random)) {
            const Eigen::Vector3d to_eye = random_direction(random);
            // Along the normal the strip is finite; open rows do not see the scene's far side.
            if (std::abs(to_eye.z()) > 0.95) continue;
            if (!row.ring && to_eye.x() < 0.2) continue;
            ++tried;
            EXPECT_EQ(entering_faces(built.mesh, point, -to_eye), 1) << row.name;
        }
        EXPECT_GT(tried, 500);
    }
}

TEST(Strip, HoldsOneOfTwoCamerasAboveEachOtherWhereAzimuthsBeginAgain) {
    const Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d behind = -normal.unitOrthogonal();
    const Eigen::Vector3d beside = normal.cross(behind);
    std::vector<OpticalAxis> axes;
    const auto add = [&](const Eigen::Vector3d& centre) {
        axes.push_back({static_cast<int>(axes.size()), centre, -centre.normalized(), 4.0});
    };
    for (int i = 1; i < 8; ++i) {
        const double azimuth = i * std::numbers::pi / 4;
        add(4 * (std::cos(azimuth) * behind + std::sin(azimuth) * beside));
    }
    // To either side of where atan2 jumps, and the second nearer to where the others stand.
    add(4.5 * behind + 1e-9 * beside + 0.5 * normal);
    add(4 * behind - 1e-9 * beside);
    for (const bool is_swapped : {false, true}) {
        if (is_swapped) std::swap(axes[7], axes[8]);
        const LineStrip strip =
            build_line_strip(camera_star(axes, Eigen::Vector3d::Zero()), normal, 10);
        EXPECT_TRUE(strip.closed_ring);
        EXPECT_EQ(strip.hidden_cameras, 1);
        ASSERT_EQ(strip.mesh.vertices.size(), 16U);
        EXPECT_EQ(strip.mesh.faces.size(), 16U);
        for (const CameraMesh::Vertex& vertex : strip.mesh.vertices) {
            EXPECT_NE(vertex.view_index, 7) << "of two the one at the usual distance is kept";
        }
    }
}

TEST(Strip, BeyondItsEndsUsesTheEndCamera) {
    const BuiltCameraMesh built = build_row(rows().front());
    const Eigen::Vector3d eye(4, 9, 0.3);
    const auto weights = weights_of_ray(built.mesh, eye, -eye);
    ASSERT_TRUE(weights.has_value());
    EXPECT_NEAR(weights_by_view(*weights, 7)[6], 1.0, 1e-12);
}

TEST(Strip, GivesACameraItsOwnRays) {
    for (const Row& row : rows()) {
        const BuiltCameraMesh built = build_row(row);
        std::mt19937 random(4);
        for (std::size_t camera = 0; camera < row.centres.size(); ++camera) {
            for (const Eigen::Vector3d& point :
                 points_in_ball(30, Eigen::Vector3d::Zero(), 0.9, random)) {
                const auto weights =
                    weights_of_ray(built.mesh, row.centres[camera], point - row.centres[camera]);
                ASSERT_TRUE(weights.has_value()) << row.name;
                EXPECT_NEAR(weights_by_view(*weights, row.centres.size())[camera], 1.0, 1e-9)
                    << row.name;
            }
        }
    }
}

}  // namespace
}  // namespace lumi
