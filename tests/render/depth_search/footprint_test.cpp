#include "render/depth_search/footprint.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>

namespace lumi {
namespace {

constexpr int kMapWidth = 90;
constexpr int kMapHeight = 70;
constexpr double kInset = 1.5;  // As footprint.h says.

/// A far plane with specks before it, some of them guesses.
DepthMap speckled(std::mt19937& random) {
    DepthMap depth{FloatImage(kMapWidth, kMapHeight, 0.1F), GrayImage(kMapWidth, kMapHeight, 255)};
    for (int i = 0; i < 60; ++i) {
        const int x = static_cast<int>(random() % kMapWidth);
        const int y = static_cast<int>(random() % kMapHeight);
        depth.inverse_depth(x, y) = 0.2F + 0.1F * static_cast<float>(random() % 8);
        depth.confidence(x, y) = random() % 3 == 0 ? 0 : 255;
    }
    return depth;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Every sample, one by one.
bool brute_force(const Footprint& triangle, double margin, const DepthMap& depth) {
    const auto& [a, b, c] = triangle.corners;
    const double area = cross(b - a, c - a);
    for (int y = 0; y < kMapHeight; ++y) {
        for (int x = 0; x < kMapWidth; ++x) {
            const Eigen::Vector2d at(x + 0.5, y + 0.5);
            bool is_inside = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const Eigen::Vector2d from = triangle.corners[k];
                const Eigen::Vector2d along = triangle.corners[(k + 1) % 3] - from;
                const double distance =
                    cross(along, at - from) / along.norm() * (area > 0 ? 1.0 : -1.0);
                is_inside = is_inside && distance >= kInset;
            }
            const Eigen::Vector3d shares(cross(c - b, at - b) / area, cross(a - c, at - c) / area,
                                         cross(b - a, at - a) / area);
            if (is_inside && depth.confidence(x, y) > 0 &&
                static_cast<double>(depth.inverse_depth(x, y)) >
                    shares.dot(triangle.inverse_depths) + margin + 1e-9)
                return true;
        }
    }
    return false;
}

TEST(Footprint, HoldsWhatEverySampleSays) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(-0.1, 1.1);
    std::uniform_real_distribution<double> size(0.05, 0.6);
    int before = 0;
    int free = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const DepthMap depth = speckled(random);
        const TiledDepth tiled(depth, GrayImage(kMapWidth, kMapHeight, 0));
        Footprint triangle;
        const Eigen::Vector2d middle(share(random) * kMapWidth, share(random) * kMapHeight);
        const double spread = size(random) * kMapHeight;
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.corners[k] =
                middle + spread * Eigen::Vector2d(share(random) - 0.5, share(random) - 0.5);
            triangle.inverse_depths[static_cast<Eigen::Index>(k)] = 0.05 + 0.4 * size(random);
        }
        const auto& [a, b, c] = triangle.corners;
        if (std::abs(cross(b - a, c - a)) < 2) continue;
        const double margin = 0.3 * size(random);
        const bool expected = brute_force(triangle, margin, depth);
        ++(expected ? before : free);
        EXPECT_EQ(is_anything_before(triangle, margin, tiled), expected) << trial;
    }
    EXPECT_GT(before, 300);
    EXPECT_GT(free, 300);
}

TEST(Footprint, OfNothingHoldsNothing) {
    std::mt19937 random(4);
    const DepthMap depth = speckled(random);
    const TiledDepth tiled(depth, GrayImage(kMapWidth, kMapHeight, 0));
    const Footprint line{{{{10, 10}, {40, 40}, {70, 70}}}, Eigen::Vector3d::Zero()};
    EXPECT_FALSE(is_anything_before(line, 0.0, tiled));
    const Footprint all{{{{0, 0}, {90, 0}, {0, 70}}}, Eigen::Vector3d::Zero()};
    EXPECT_TRUE(is_anything_before(all, 0.0, tiled));
    EXPECT_FALSE(is_anything_before(all, 0.0, TiledDepth()));
    EXPECT_FALSE(is_anything_before(all, 2.0, tiled)) << "nothing is so near";
}

}  // namespace
}  // namespace lumi
