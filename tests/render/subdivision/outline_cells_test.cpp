#include "render/subdivision/outline_cells.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

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
    [[nodiscard]] OutlineCells cells_for(const Eye& eye, const std::vector<int>& view_indices) {
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

}  // namespace
}  // namespace lumi
