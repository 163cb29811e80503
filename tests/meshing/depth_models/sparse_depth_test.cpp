#include "meshing/depth_models/sparse_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

DepthView empty_view() {
    DepthView view;
    view.camera = small_camera();
    view.range = {0.1, 0.5};
    view.disparity_px_per_inverse_depth = 100;
    return view;
}

double affine(const Eigen::Vector2d& pixel) {
    return 0.3 + 0.0004 * pixel.x() - 0.0007 * pixel.y();
}

std::vector<SparsePoint> points_on_a_plane(int count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(0, 240);
    std::uniform_real_distribution<double> y(0, 180);
    std::vector<SparsePoint> points;
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector2d pixel(x(random), y(random));
        points.push_back({pixel, affine(pixel)});
    }
    return points;
}

TEST(SparseDepth, WithoutPointsIsTheMiddleOfTheRangeAndTrustsNothing) {
    const DepthMap map = sparse_depth(empty_view());
    EXPECT_EQ(map.inverse_depth, FloatImage(240, 180, 0.3F));
    EXPECT_EQ(map.confidence, GrayImage(240, 180, 0));
}

TEST(SparseDepth, OnePointGivesAConstant) {
    DepthView view = empty_view();
    view.points = {{{50, 60}, 0.25}};
    const DepthMap map = sparse_depth(view);
    for (const float value : map.inverse_depth.pixels()) ASSERT_NEAR(value, 0.25F, 1e-6F);
    EXPECT_EQ(map.confidence(50, 60), 127);
    EXPECT_EQ(map.confidence(239, 179), 0);
}

TEST(SparseDepth, FewPointsStayWithinWhatWasSeen) {
    DepthView view = empty_view();
    view.points = {{{50, 60}, 0.2}, {{200, 100}, 0.4}};
    for (int extra = 0; extra < 2; ++extra) {
        const DepthMap map = sparse_depth(view);
        const auto [least, most] = std::minmax_element(map.inverse_depth.pixels().begin(),
                                                       map.inverse_depth.pixels().end());
        EXPECT_GE(*least, 0.2F - 1e-6F);
        EXPECT_LE(*most, 0.4F + 1e-6F);
        EXPECT_NEAR(map.inverse_depth(50, 60), 0.2F, 0.01F);
        EXPECT_NEAR(map.inverse_depth(200, 100), 0.4F, 0.01F);
        view.points.push_back({{120, 20}, 0.3});
    }
}

TEST(SparseDepth, ReproducesAPlaneBetweenItsPoints) {
    DepthView view = empty_view();
    view.points = points_on_a_plane(300);
    const DepthMap map = sparse_depth(view);
    for (int y = 30; y < 150; ++y) {
        for (int x = 30; x < 210; ++x) {
            ASSERT_NEAR(map.inverse_depth(x, y), affine({x + 0.5, y + 0.5}), 1e-6) << x << " " << y;
        }
    }
    for (const float value : map.inverse_depth.pixels()) ASSERT_GT(value, 0.1F);
}

TEST(SparseDepth, DropsThePointsThatDisagreeWithTheirRing) {
    std::vector<SparsePoint> points = points_on_a_plane(300);
    points[17].inverse_depth += 0.4;
    points[120].inverse_depth -= 0.2;
    const std::vector<SparsePoint> kept = without_outliers(points, 0.05);
    EXPECT_EQ(kept.size(), 298U);
    for (const SparsePoint& point : kept) {
        EXPECT_NEAR(point.inverse_depth, affine(point.pixel), 1e-12);
    }
}

TEST(SparseDepth, PointsAtOnePixelAreNoTrouble) {
    DepthView view = empty_view();
    view.points.assign(20, {{50, 60}, 0.25});
    const DepthMap map = sparse_depth(view);
    for (const float value : map.inverse_depth.pixels()) {
        ASSERT_NEAR(value, 0.25F, 1e-6F);
    }
}

}  // namespace
}  // namespace lumi
