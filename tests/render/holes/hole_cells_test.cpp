#include "render/holes/hole_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lumi {
namespace {

/// Three whole cells across and a quarter of one, two down and a half.
const Camera kCamera = pinhole_camera(52, 40, 50);

using Cell = std::pair<int, int>;  ///< Column and row.

template <class IsHole>
std::set<Cell> marked(const IsHole& is_hole) {
    const PictureCells cells = hole_cells(kCamera, is_hole);
    std::set<Cell> all;
    for (int row = 0; row < cells.rows(); ++row)
        for (int column = 0; column < cells.columns(); ++column)
            if (cells.is_marked(column, row)) all.emplace(column, row);
    return all;
}

TEST(HoleCells, AreThoseOfTheHole) {
    EXPECT_TRUE(marked([](const Eigen::Vector2d&) { return false; }).empty());
    EXPECT_EQ(marked([](const Eigen::Vector2d&) { return true; }).size(), 12U);
    EXPECT_EQ(marked([](const Eigen::Vector2d& at) { return at.x() < 16 && at.y() > 32; }),
              (std::set<Cell>{{0, 2}}));
}

TEST(HoleCells, AreThoseWithAQuarterOfItOrMore) {
    EXPECT_EQ(marked([](const Eigen::Vector2d& at) { return at.x() > 28 && at.y() < 16; }),
              (std::set<Cell>{{1, 0}, {2, 0}, {3, 0}}));
    EXPECT_EQ(marked([](const Eigen::Vector2d& at) { return at.x() > 31 && at.y() < 16; }),
              (std::set<Cell>{{2, 0}, {3, 0}}));
}

TEST(HoleCells, AreNotWhereALineOfItPasses) {
    EXPECT_TRUE(marked([](const Eigen::Vector2d& at) {
                    return std::abs(at.x() - at.y() + 2) < 1.5;
                }).empty());
}

TEST(HoleCells, AskNothingBeyondThePicture) {
    static_cast<void>(marked([](const Eigen::Vector2d& at) {
        EXPECT_LT(at.x(), 52);
        EXPECT_LT(at.y(), 40);
        return true;
    }));
}

}  // namespace
}  // namespace lumi
