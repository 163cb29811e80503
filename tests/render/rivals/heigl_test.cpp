#include "render/rivals/heigl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "meshing/surface/camera_mesh.h"
#include "render/rivals/planar_delaunay.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

TEST(PlanarDelaunay, LeavesNoPointWithinACircle) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-3, 5);
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 40; ++i) points.emplace_back(place(random), place(random));
    const auto triangles = planar_delaunay(points);
    ASSERT_GT(triangles.size(), 40U);
    for (const auto& triangle : triangles) {
        const Eigen::Vector2d& a = points[static_cast<std::size_t>(triangle[0])];
        const Eigen::Vector2d& b = points[static_cast<std::size_t>(triangle[1])];
        const Eigen::Vector2d& c = points[static_cast<std::size_t>(triangle[2])];
        Eigen::Matrix2d sides;
        sides << (b - a).transpose(), (c - a).transpose();
        EXPECT_GT(sides.determinant(), 0);
        const Eigen::Vector2d centre =
            a + sides.inverse() * Eigen::Vector2d((b - a).squaredNorm(), (c - a).squaredNorm()) / 2;
        for (const Eigen::Vector2d& point : points)
            EXPECT_GT((point - centre).norm(), (a - centre).norm() * (1 - 1e-6));
    }
}

TEST(PlanarDelaunay, DividesWhatLiesBetweenPointsHoweverUnlikeTheirDistancesAre) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1, 1);
    for (const double far : {1e2, 1e4, 1e6}) {
        // A square around ten points in its middle.
        std::vector<Eigen::Vector2d> points{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
        for (int i = 0; i < 10; ++i) points.emplace_back(place(random), place(random));
        double doubled_area = 0;
        const auto triangles = planar_delaunay(points);
        for (const auto& triangle : triangles) {
            const Eigen::Vector2d& a = points[static_cast<std::size_t>(triangle[0])];
            Eigen::Matrix2d sides;
            sides << (points[static_cast<std::size_t>(triangle[1])] - a).transpose(),
                (points[static_cast<std::size_t>(triangle[2])] - a).transpose();
            EXPECT_GT(sides.determinant(), 0) << far;
            doubled_area += sides.determinant();
        }
        EXPECT_NEAR(doubled_area, 8 * far * far, 1e-6 * far * far);
        // Of n points, of which h are on the hull, 2 n - h - 2.
        EXPECT_EQ(triangles.size(), 22U) << far;
    }
}

TEST(PlanarDelaunay, OfALineOrOfTwoPointsIsNothing) {
    EXPECT_TRUE(planar_delaunay({{0, 0}, {1, 1}}).empty());
    EXPECT_TRUE(planar_delaunay({{0, 0}, {1, 0}, {2, 0}, {3, 0}}).empty());
    EXPECT_EQ(planar_delaunay({{0, 0}, {1, 0}, {1, 0}, {0, 1}}).size(), 1U);
}

std::array<double, 9> weights_of_views(const std::vector<FacePolygon>& polygons,
                                       const Eigen::Vector2d& pixel) {
    std::array<double, 9> weights{};
    for (const FacePolygon& polygon : polygons) {
        bool inside = true;
        for (const Eigen::Vector3d& line : polygon.side_lines)
            inside = inside && line.dot(pixel.homogeneous()) >= 0;
        if (!inside) continue;
        const auto at = weights_at(polygon, pixel);
        for (std::size_t k = 0; k < 3; ++k)
            weights[static_cast<std::size_t>(polygon.view_indices[k])] = at[k];
    }
    return weights;
}

/// Half of the sum of differences between the weights of one ray, seen from two places on it.
double inconsistency(const Lumigraph& lumigraph, const Eigen::Vector3d& target, bool heigl) {
    std::array<std::array<double, 9>, 2> weights{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Eigen::Vector3d far_end(0.17, 0.11, -3.0);
        const Eigen::Vector3d place = far_end + (i == 0 ? 0.0 : 0.55) * (target - far_end);
        const Eye eye = eye_at(place, target, pinhole_camera(64, 48, 60));
        weights[i] = weights_of_views(
            heigl ? heigl_polygons(lumigraph, eye) : face_polygons(lumigraph.mesh, eye), {32, 24});
    }
    double sum = 0;
    for (std::size_t k = 0; k < 9; ++k) sum += 0.5 * std::abs(weights[0][k] - weights[1][k]);
    return sum;
}

TEST(Heigl, BlendsOneRayFromOtherViewsWhenTheEyeMovesAlongItAsTheCameraMeshDoesNot) {
    const Lumigraph lumigraph = card_before_wall();
    double heigl = 0;
    double mesh = 0;
    for (double x = -0.3; x < 0.35; x += 0.1) {
        heigl += inconsistency(lumigraph, {x, 0.05, 3}, true);
        mesh += inconsistency(lumigraph, {x, 0.05, 3}, false);
    }
    EXPECT_GT(heigl, 1e-3);
    EXPECT_LT(mesh, 1e-9);
}

TEST(Heigl, GivesACameraAllTheWeightWhereItStands) {
    const Lumigraph lumigraph = card_before_wall();
    const Eigen::Vector3d camera = centre_in_world(lumigraph.views[0].cam_from_world);
    const Eye eye = eye_at({0.1, 0.05, -2}, camera, pinhole_camera(64, 48, 60));
    EXPECT_NEAR(weights_of_views(heigl_polygons(lumigraph, eye), {32, 24})[0], 1, 1e-6);
}

TEST(Heigl, DrawsInThePlaneOfAllCamerasWhatItDrawsBesideIt) {
    std::vector<Eye> cameras;
    for (const double x : {-1.0, 0.1, 1.0})
        for (const double y : {-1.0, 0.05, 1.0})
            cameras.push_back(eye_at({x, y, 0}, {x, y, 5}, pinhole_camera(64, 48, 60)));
    const Lumigraph lumigraph = photographed(AnalyticScene::kCardBeforeWall, cameras);
    const auto weights_at_z = [&](double z) {
        const Eye eye = eye_at({0.4, 0.3, z}, {0.4, 0.3, 5}, pinhole_camera(64, 48, 60));
        return weights_of_views(heigl_polygons(lumigraph, eye), {30, 20});
    };
    const auto in_plane = weights_at_z(0);
    EXPECT_NEAR(std::accumulate(in_plane.begin(), in_plane.end(), 0.0), 1, 1e-6);
    for (const double z : {-1e-5, -1e-7, -1e-10, 1e-12, 1e-8, 1e-5}) {
        const auto beside = weights_at_z(z);
        for (std::size_t view = 0; view < in_plane.size(); ++view)
            EXPECT_NEAR(beside[view], in_plane[view], 1e-3) << view << " at " << z;
    }
}

TEST(Heigl, LeavesOutViewsThatLookElsewhere) {
    std::vector<Eye> cameras;
    for (int i = 0; i < 64; ++i) {
        // Spread evenly over a sphere.
        const double z = 1 - (2 * i + 1) / 64.0;
        const double turn = 2.39996 * i;
        const double beside = std::sqrt(1 - z * z);
        cameras.push_back(
            eye_at(4 * Eigen::Vector3d(beside * std::cos(turn), beside * std::sin(turn), z),
                   {0, 0, 0}, pinhole_camera(64, 48, 60)));
    }
    const Lumigraph lumigraph = photographed(AnalyticScene::kBallInSky, cameras);
    const Eye eye = eye_at({0.5, 0.6, -4}, {0, 0, 0}, pinhole_camera(64, 48, 60));
    const Eigen::Vector3d axis = optical_axis_in_world(eye.cam_from_world);
    const std::vector<FacePolygon> polygons = heigl_polygons(lumigraph, eye);
    ASSERT_FALSE(polygons.empty());
    for (const FacePolygon& polygon : polygons)
        for (const int view : polygon.view_indices)
            EXPECT_GT(optical_axis_in_world(
                          lumigraph.views[static_cast<std::size_t>(view)].cam_from_world)
                          .dot(axis),
                      std::cos(0.251 * std::numbers::pi));
}

}  // namespace
}  // namespace lumi
