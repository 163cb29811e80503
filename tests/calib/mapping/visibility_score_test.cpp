#include "calib/mapping/visibility_score.h"

#include <gtest/gtest.h>

#include <vector>

namespace lumi {
namespace {

const Camera kSquareCamera = pinhole_camera(640, 640, 600);

/// Of one pixel: a cell of each of the grids of 4, 16, ... 4096 cells, worth as many points as its
/// grid has cells.
constexpr double kOfOnePixel = 4 + 16 + 64 + 256 + 1024 + 4096;

double score_of(const std::vector<Eigen::Vector2d>& pixels) {
    return visibility_score(kSquareCamera, pixels);
}

TEST(VisibilityScore, CountsTheCellsOfEveryGridThatAreHit) {
    EXPECT_EQ(score_of({}), 0);
    EXPECT_EQ(score_of({{100, 100}}), kOfOnePixel);
    EXPECT_EQ(score_of({{100, 100}, {500, 500}}), 2 * kOfOnePixel);
}

TEST(VisibilityScore, PixelsOfOneCellCountOnce) {
    EXPECT_EQ(score_of({{101, 101}, {102, 102}, {103, 103}}), kOfOnePixel);
    // In one cell of the grids up to 16 x 16, each 40 px wide, and in two of the finer ones.
    EXPECT_EQ(score_of({{1, 1}, {39, 39}}), kOfOnePixel + 1024 + 4096);
}

TEST(VisibilityScore, AsManyPixelsAreWorthMoreWhereTheyAreSpread) {
    std::vector<Eigen::Vector2d> together;
    std::vector<Eigen::Vector2d> spread;
    for (int index = 0; index < 10; ++index) {
        together.emplace_back(300 + 3 * index, 300);
        spread.emplace_back(30 + 60 * index, 600 - 60 * index);
    }
    EXPECT_GT(score_of(spread), 2 * score_of(together));
}

}  // namespace
}  // namespace lumi
