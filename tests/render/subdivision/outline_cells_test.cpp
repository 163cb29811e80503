#include "render/subdivision/outline_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "render/subdivision/adaptive_subdivision.h"
#include "render/subdivision/coarse_triangles.h"
#include "render/transfer/scene_plane.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr double kLensFocal_px = 260.0;
/// Half of the card's width and height as a camera before its middle sees them.
constexpr double kHalfCardWidth_px = kLensFocal_px * 0.7 / 3;
constexpr double kHalfCardHeight_px = kLensFocal_px * 0.5 / 3;
const Eigen::Vector2d kMiddle_px(128, 96);
constexpr float kCardBeforeWallStep = 1.0F / 3 - 1.0F / 6;

Eye ahead_from(double x, double y) {
    return eye_at({x, y, 0}, {x, y, 6}, pinhole_camera(256, 192, kLensFocal_px));
}

/// How far a pixel of the eye's picture lies from the outline of a card whose middle is seen there.
double to_outline_px(const Eigen::Vector2d& pixel, const Eigen::Vector2d& card_middle_px) {
    const Eigen::Vector2d beyond = (pixel - card_middle_px).cwiseAbs() -
                                   Eigen::Vector2d(kHalfCardWidth_px, kHalfCardHeight_px);
    if (beyond.maxCoeff() < 0) return -beyond.maxCoeff();
    return beyond.cwiseMax(0.0).norm();
}

class OutlinesOfCard : public testing::Test {
 protected:
    [[nodiscard]] OutlineCells cells_for(const Eye& eye,
                                         const std::vector<int>& view_indices) const {
        return {card_, views_, view_indices, eye};
    }

    Lumigraph card_ = photographed(AnalyticScene::kCardBeforeWall,
                                   {ahead_from(0.4, 0.3), ahead_from(-0.4, 0.3),
                                    ahead_from(-0.4, -0.3), ahead_from(0.4, -0.3)});
    SearchedViews views_ = searched_views(card_);
    Eye eye_ = ahead_from(0, 0);
};

TEST_F(OutlinesOfCard, PointsOfAViewLieOnTheCardAlongItsOutline) {
    // The first camera stands to the right of the card's middle, and below it.
    const Eigen::Vector2d seen_at = kMiddle_px - kLensFocal_px / 3 * Eigen::Vector2d(0.4, 0.3);
    ASSERT_GT(static_cast<double>(views_.outlines[0].size()),
              (kHalfCardWidth_px + kHalfCardHeight_px) / 2);
    for (const OutlinePoint& point : views_.outlines[0]) {
        const Eigen::Vector2d pixel(point.x_px, point.y_px);
        EXPECT_LT(to_outline_px(pixel, seen_at), 2.0) << pixel.transpose();
        EXPECT_NEAR(point.inverse_depth, 1.0F / 3, 1e-4F);
        EXPECT_NEAR(point.step, kCardBeforeWallStep, 1e-4F);
    }
}

TEST_F(OutlinesOfCard, AGuessHasNone) {
    for (LumigraphView& view : card_.views)
        for (std::uint8_t& confidence : view.depth.confidence.pixels()) confidence = 0;
    for (const std::vector<OutlinePoint>& points : searched_views(card_).outlines)
        EXPECT_TRUE(points.empty());
}

TEST_F(OutlinesOfCard, OfATriangleAroundSomeOfItAnEdgeKnows) {
    const OutlineCells cells = cells_for(eye_, {0, 1, 2, 3});
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x_px(0, 256);
    std::uniform_real_distribution<double> y_px(0, 192);
    std::uniform_real_distribution<double> share(-1, 1);
    int around = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const Eigen::Vector2d on_outline =
            kMiddle_px +
            (trial % 2 == 0
                 ? Eigen::Vector2d(share(random) * kHalfCardWidth_px, kHalfCardHeight_px)
                 : Eigen::Vector2d(kHalfCardWidth_px, share(random) * kHalfCardHeight_px));
        std::array<Eigen::Vector2d, 3> corners;
        for (Eigen::Vector2d& corner : corners) corner = {x_px(random), y_px(random)};
        std::array<double, 3> sides{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector2d along = corners[(i + 1) % 3] - corners[i];
            const Eigen::Vector2d to_point = on_outline - corners[i];
            sides[i] = along.x() * to_point.y() - along.y() * to_point.x();
        }
        const bool is_within = (sides[0] > 0) == (sides[1] > 0) && (sides[1] > 0) == (sides[2] > 0);
        if (!is_within) continue;
        ++around;
        EXPECT_TRUE(cells.has_beside(corners[0], corners[1]) ||
                    cells.has_beside(corners[1], corners[2]) ||
                    cells.has_beside(corners[2], corners[0]))
            << on_outline.transpose();
    }
    EXPECT_GT(around, 1000);
}

TEST_F(OutlinesOfCard, EdgesFarFromItKnowOfNone) {
    const OutlineCells cells = cells_for(eye_, {0, 1, 2, 3});
    EXPECT_FALSE(cells.has_beside({90, 80}, {160, 80})) << "on the card";
    EXPECT_FALSE(cells.has_beside({10, 10}, {10, 180})) << "on the wall";
    EXPECT_TRUE(cells.has_beside({10, 90}, {100, 90})) << "from one to the other";
    EXPECT_TRUE(cells.has_beside({100, 90}, {10, 90})) << "and back";
    EXPECT_FALSE(OutlineCells().has_beside({10, 90}, {100, 90})) << "nobody was asked";
}

// Its photograph shows there what the eye sees, whatever the depth.
TEST_F(OutlinesOfCard, AnEyeAtACameraNeedsNoneOfThatCamera) {
    const Eye at_camera = ahead_from(0.4, 0.3);
    EXPECT_FALSE(cells_for(at_camera, {0}).has_beside({0, 0}, {256, 192}));
    EXPECT_TRUE(cells_for(at_camera, {1}).has_beside({0, 0}, {256, 192}));
}

// The wall moves against the card by 43 pixels for each unit that the eye stands aside.
TEST_F(OutlinesOfCard, StepsThatHardlyMoveDoNotCount) {
    const auto knows = [&](double aside) {
        return cells_for(ahead_from(0.4 - aside, 0.3), {0}).has_beside({0, 0}, {256, 192});
    };
    const double enough = 12 / (kLensFocal_px * static_cast<double>(kCardBeforeWallStep));
    EXPECT_FALSE(knows(0.99 * enough));
    EXPECT_TRUE(knows(1.01 * enough));
}

double area_of_px2(const BlendTriangles& triangles, std::size_t first_index) {
    const auto corner = [&](std::size_t i) {
        return vector_of(triangles.vertices[triangles.indices[first_index + i]].pixel);
    };
    return 0.5 * doubled_area_px2(corner(1) - corner(0), corner(2) - corner(0));
}

/// A bar of four pixels between the corners and the middles of large triangles.
class OutlinedBar : public testing::Test {
 protected:
    [[nodiscard]] BlendTriangles subdivided(const AdaptiveSubdivisionOptions& options,
                                            const OutlineCells& outlines) const {
        return AdaptiveSubdivider()
            .subdivide(face_polygons(bar_.mesh, eye_), search_,
                       scene_plane_inverse_depth(bar_, eye_), {}, options, outlines)
            .triangles;
    }
    /// How much of the picture is drawn on it.
    [[nodiscard]] double on_bar_px2(const BlendTriangles& triangles) const {
        double sum_px2 = 0;
        for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
            const auto first = triangles.indices.begin() + static_cast<std::ptrdiff_t>(i);
            const bool is_on_bar = std::all_of(first, first + 3, [&](std::uint32_t corner) {
                return triangles.vertices[corner].inverse_depth > 0.25F;
            });
            if (is_on_bar) sum_px2 += area_of_px2(triangles, i);
        }
        return sum_px2;
    }

    Lumigraph bar_ = photographed(AnalyticScene::kBarBeforeWall,
                                  {ahead_from(0.4, 0.3), ahead_from(-0.4, 0.3),
                                   ahead_from(-0.4, -0.3), ahead_from(0.4, -0.3)});
    SearchedViews views_ = searched_views(bar_);
    Eye eye_ = ahead_from(0.1, 0);
    DepthSearch search_{bar_, views_, eye_};
    OutlineCells outlines_{bar_, views_, {0, 1, 2, 3}, eye_};
};

TEST_F(OutlinedBar, IsFoundByItsOutline) {
    const double bar_px2 = kLensFocal_px * 0.046 / 3 * kLensFocal_px * 1.6 / 3;
    const AdaptiveSubdivisionOptions options{.min_edge_px = 4};
    EXPECT_LT(on_bar_px2(subdivided(options, {})), 0.1 * bar_px2);
    EXPECT_NEAR(on_bar_px2(subdivided(options, outlines_)), bar_px2, 0.1 * bar_px2);
}

// They are worth their triangles only where much may be missed.
TEST_F(OutlinedBar, ShortEdgesAreNotSplitForIt) {
    const AdaptiveSubdivisionOptions options{.min_edge_px = 8, .max_edge_px = 24};
    EXPECT_EQ(subdivided(options, outlines_).count(), subdivided(options, {}).count());
}

}  // namespace
}  // namespace lumi
