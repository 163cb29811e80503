#include "render/transfer/polygon_extent.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lumi {
namespace {

std::vector<Eigen::Vector2d> regular_polygon(int corners, double radius, double turn) {
    std::vector<Eigen::Vector2d> polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = turn * 2 * std::numbers::pi * i / corners;
        polygon.emplace_back(3 + radius * std::cos(angle), -2 + radius * std::sin(angle));
    }
    return polygon;
}

TEST(PolygonExtent, TheAreaOfARegularPolygonIsKnownWhicheverWayItTurns) {
    for (const int corners : {3, 4, 6, 17}) {
        const double area = 0.5 * corners * 25 * std::sin(2 * std::numbers::pi / corners);
        EXPECT_NEAR(area_px2(regular_polygon(corners, 5, 1)), area, 1e-12);
        EXPECT_NEAR(area_px2(regular_polygon(corners, 5, -1)), area, 1e-12);
    }
}

TEST(PolygonExtent, APolygonOfLessThanThreeCornersHasNoArea) {
    EXPECT_EQ(area_px2({}), 0);
    EXPECT_EQ(area_px2({{1, 2}}), 0);
    EXPECT_EQ(area_px2({{1, 2}, {3, 5}}), 0);
}

TEST(PolygonExtent, ATriangleTurnsFromXToYOrBack) {
    EXPECT_EQ(signed_doubled_area({2, 0}, {0, 3}), 6);
    EXPECT_EQ(signed_doubled_area({0, 3}, {2, 0}), -6);
    EXPECT_EQ(doubled_area_px2({0, 3}, {2, 0}), 6);
}

TEST(PolygonExtent, TheBoundingBoxTouchesTheOutermostCorners) {
    const std::vector<Eigen::Vector2d> square = regular_polygon(4, 5, 1);
    const Eigen::AlignedBox2d box = bounding_box(square);
    EXPECT_TRUE(box.min().isApprox(Eigen::Vector2d(-2, -7)));
    EXPECT_TRUE(box.max().isApprox(Eigen::Vector2d(8, 3)));
    EXPECT_TRUE(bounding_box({}).isEmpty());
}

}  // namespace
}  // namespace lumi
