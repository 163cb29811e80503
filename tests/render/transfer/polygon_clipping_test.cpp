#include "render/transfer/polygon_clipping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "render/transfer/polygon_extent.h"

namespace lumi {
namespace {

double any_between(double low, double high, std::mt19937& random) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Three to nine corners on an ellipse, either way around.
std::vector<Eigen::Vector2d> convex_polygon(std::mt19937& random) {
    std::vector<double> angles(3 + random() % 7);
    for (double& angle : angles) angle = any_between(0, 2 * std::numbers::pi, random);
    std::sort(angles.begin(), angles.end());
    if (random() % 2 == 0) std::reverse(angles.begin(), angles.end());
    std::vector<Eigen::Vector2d> polygon;
    for (const double angle : angles)
        polygon.emplace_back(7 + 5 * std::cos(angle), -2 + 3 * std::sin(angle));
    return polygon;
}

/// Through a point about the ellipse, in any direction, times any factor.
Eigen::Vector3d line_across(std::mt19937& random) {
    const Eigen::Vector2d point(any_between(2, 12, random), any_between(-5, 1, random));
    const double angle = any_between(0, 2 * std::numbers::pi, random);
    const Eigen::Vector2d normal =
        any_between(0.1, 10, random) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    return {normal.x(), normal.y(), -normal.dot(point)};
}

double value_at(const Eigen::Vector3d& line, const Eigen::Vector2d& point) {
    return line.dot(point.homogeneous());
}

TEST(PolygonClipping, CutsAConvexPolygonInTwoPartsOneOnEachSide) {
    std::mt19937 random(1);
    int cut = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const std::vector<Eigen::Vector2d> polygon = convex_polygon(random);
        const Eigen::Vector3d line = line_across(random);
        const std::vector<Eigen::Vector2d> before = clipped(polygon, line);
        const std::vector<Eigen::Vector2d> behind = clipped(polygon, -line);
        ASSERT_NEAR(area_px2(before) + area_px2(behind), area_px2(polygon), 1e-9);
        for (const Eigen::Vector2d& corner : before) ASSERT_GE(value_at(line, corner), -1e-9);
        for (const Eigen::Vector2d& corner : behind) ASSERT_LE(value_at(line, corner), 1e-9);
        if (area_px2(before) > 0 && area_px2(behind) > 0) ++cut;
    }
    EXPECT_GT(cut, 300);
}

TEST(PolygonClipping, KeepsWhatALineOfZerosWouldCut) {
    std::mt19937 random(2);
    const std::vector<Eigen::Vector2d> polygon = convex_polygon(random);
    EXPECT_EQ(clipped(polygon, Eigen::Vector3d::Zero()), polygon);
    EXPECT_TRUE(clipped({}, line_across(random)).empty());
}

TEST(PolygonClipping, PartsBetweenParallelLinesAddUp) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 200; ++trial) {
        const std::vector<Eigen::Vector2d> polygon = convex_polygon(random);
        for (const Eigen::Index axis : {0, 1}) {
            double sum = 0;
            for (int low = -6; low < 13; low += 2) {
                const auto part = clipped_between(polygon, axis, low, low + 2);
                sum += area_px2(part);
                for (const Eigen::Vector2d& corner : part) {
                    ASSERT_GE(corner[axis], low - 1e-9);
                    ASSERT_LE(corner[axis], low + 2 + 1e-9);
                }
            }
            ASSERT_NEAR(sum, area_px2(polygon), 1e-9);
        }
    }
}

TEST(PolygonClipping, LeavesOfABoxWhatBothShare) {
    const std::vector<Eigen::Vector2d> diamond{{2, 0}, {0, 2}, {-2, 0}, {0, -2}};
    EXPECT_NEAR(area_px2(clipped(
                    diamond, Eigen::AlignedBox2d(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1)))),
                4.0, 1e-12);
    EXPECT_NEAR(area_px2(clipped(
                    diamond, Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(5, 5)))),
                2.0, 1e-12);
    EXPECT_EQ(area_px2(clipped(diamond,
                               Eigen::AlignedBox2d(Eigen::Vector2d(3, 3), Eigen::Vector2d(5, 5)))),
              0.0);
}

}  // namespace
}  // namespace lumi
