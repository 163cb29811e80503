#include "calib/boards/lattice.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>

#include <cmath>
#include <random>

#include "calib/boards/lattice_basis.h"

namespace lumi {
namespace {

const LinkTest kAnyLink = [](std::size_t, std::size_t, int, int) { return true; };

/// Nodes of a lattice under a homography, in a shuffled order, with clutter around.
std::vector<Eigen::Vector2d> scattered(int columns, int rows, std::size_t clutter) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    Eigen::Matrix3d homography;
    homography << 30, 4, 60, -3, 27, 50, 0.012, 0.004, 1;
    std::vector<Eigen::Vector2d> points;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            points.push_back((homography * Eigen::Vector3d(column, row, 1)).hnormalized());
        }
    }
    for (std::size_t index = 0; index < clutter; ++index) {
        points.emplace_back(400 + 200 * uniform(random), 300 * uniform(random));
    }
    std::shuffle(points.begin(), points.end(), random);
    return points;
}

TEST(Lattice, GrowsOverThePatternAndNotOverClutter) {
    const std::vector<Eigen::Vector2d> points = scattered(10, 7, 60);
    const Lattice lattice = largest_lattice(PointGrid(points), kAnyLink);
    EXPECT_EQ(lattice.size(), 70u);
    const LatticeExtent extent = extent_of(lattice);
    EXPECT_EQ(std::minmax({extent.columns(), extent.rows()}), std::minmax({7, 10}));
}

TEST(Lattice, GapsAreBridged) {
    std::vector<Eigen::Vector2d> points = scattered(10, 7, 0);
    points.erase(points.begin() + 11);
    points.erase(points.begin() + 30);
    EXPECT_EQ(largest_lattice(PointGrid(points), kAnyLink).size(), 68u);
}

TEST(Lattice, FewScatteredPointsAreNone) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> uniform(0.0, 600.0);
    std::vector<Eigen::Vector2d> points;
    for (int index = 0; index < 50; ++index) points.emplace_back(uniform(random), uniform(random));
    EXPECT_TRUE(largest_lattice(PointGrid(points), kAnyLink).empty());
    EXPECT_TRUE(largest_lattice(PointGrid({}), kAnyLink).empty());
}

TEST(PointGrid, FindsWhatASearchThroughAllPointsFinds) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(-50.0, 300.0);
    std::vector<Eigen::Vector2d> points;
    for (int index = 0; index < 300; ++index) points.emplace_back(uniform(random), uniform(random));
    const PointGrid grid(points);
    for (int query = 0; query < 50; ++query) {
        const Eigen::Vector2d where(uniform(random), uniform(random));
        std::size_t expected = 0;
        for (const Eigen::Vector2d& point : points) expected += (point - where).norm() <= 40;
        EXPECT_EQ(grid.within(where, 40).size(), expected);
    }
    EXPECT_EQ(grid.neighbours(0, 5).size(), 5u);
    EXPECT_EQ(grid.neighbours(0, 1000).size(), 299u);
}

TEST(LatticeBasis, ReducesAnyBasisOfAPatternToItsShape) {
    Eigen::Matrix2d square = Eigen::Matrix2d::Identity();
    Eigen::Matrix2d hexagonal;
    hexagonal << 1, 0.5, 0, std::sqrt(0.75);
    Eigen::Matrix2d oblong;
    oblong << 1, 0, 0, 1.6;
    for (const auto& change :
         {std::array{1, 0, 0, 1}, std::array{1, 1, 0, 1}, std::array{2, 1, 1, 1},
          std::array{0, 1, 1, 0}, std::array{1, -1, 0, 1}, std::array{3, 2, 4, 3}}) {
        Eigen::Matrix2d basis;
        basis << change[0], change[1], change[2], change[3];
        const auto shape_of = [&](const Eigen::Matrix2d& steps) {
            const Eigen::Matrix2d found = steps * basis;
            return reduced_basis(found.transpose() * found);
        };
        EXPECT_EQ(shape_of(square).shape, LatticeShape::kSquare);
        EXPECT_EQ(shape_of(hexagonal).shape, LatticeShape::kHexagonal);
        EXPECT_EQ(shape_of(oblong).shape, LatticeShape::kOther);
        // Distances between cells are kept.
        const LatticeBasis reduced = shape_of(hexagonal);
        const LatticeCell a = changed({2, -1}, reduced.reduced_from_found);
        const LatticeCell b = changed({-1, 3}, reduced.reduced_from_found);
        const double distance =
            (position_of(a, LatticeShape::kHexagonal) - position_of(b, LatticeShape::kHexagonal))
                .norm();
        EXPECT_NEAR(distance, (hexagonal * basis * Eigen::Vector2d(3, -4)).norm(), 1e-9);
    }
}

}  // namespace
}  // namespace lumi
