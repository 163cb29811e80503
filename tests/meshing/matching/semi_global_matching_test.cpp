#include "meshing/matching/semi_global_matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace lumi {
namespace {

constexpr int kWidth_px = 45;  // Three tiles, the last one cut.

CostVolume random_costs(int height, std::vector<TilePlanes> tiles, unsigned seed) {
    CostVolume volume(kWidth_px, height, std::move(tiles));
    std::mt19937 random(seed);
    for (std::uint8_t& cost : volume.costs()) {
        cost = static_cast<std::uint8_t>(random() % (kMaxMatchingCost + 1));
    }
    return volume;
}

GrayImage random_gray(int height, unsigned seed) {
    GrayImage gray(kWidth_px, height);
    std::mt19937 random(seed);
    for (std::uint8_t& value : gray.pixels()) value = static_cast<std::uint8_t>(random() % 256);
    return gray;
}

int jump_penalty(const SmoothnessPenalty& penalty, int difference) {
    return static_cast<int>(
        std::lround(penalty.jump_at_edge + std::exp(-difference / penalty.edge_gray) *
                                               (penalty.jump - penalty.jump_at_edge)));
}

/// By how many planes index 0 of a pixel lies beyond that of the pixel at `step` before it, were
/// their surface to slope as the mean of both tiles does.
int planes_beyond(const CostVolume& volume, const Eigen::Vector2i& at,
                  const Eigen::Vector2i& step) {
    const Eigen::Vector2i from = at - step;
    const Eigen::Vector2d slope =
        0.5 * (volume.tile(from.x(), from.y()).slope + volume.tile(at.x(), at.y()).slope);
    return static_cast<int>(std::lround(volume.first_plane(at.x(), at.y()) -
                                        volume.first_plane(from.x(), from.y()) -
                                        slope.dot(step.cast<double>())));
}

/// Hirschmueller's recurrence by its definition, over absolute planes: the costs of the paths
/// along `step`, in the layout of the volume's costs.
std::vector<int> path_costs(const CostVolume& volume, const GrayImage& gray,
                            const SmoothnessPenalty& penalty, const Eigen::Vector2i& step) {
    std::vector<int> costs(volume.costs().begin(), volume.costs().end());
    for (int i = 0; i < gray.width() * gray.height(); ++i) {
        const int column = i % gray.width();
        const int row = i / gray.width();
        const Eigen::Vector2i at(step.x() > 0 ? column : gray.width() - 1 - column,
                                 step.y() > 0 ? row : gray.height() - 1 - row);
        const Eigen::Vector2i from = at - step;
        if (!gray.contains(from.x(), from.y())) continue;
        const int* before = costs.data() + volume.offset(from.x(), from.y());
        const int before_count = volume.tile(from.x(), from.y()).count;
        const int least = *std::min_element(before, before + before_count);
        const int difference = std::abs(gray(at.x(), at.y()) - gray(from.x(), from.y()));
        const int beyond = planes_beyond(volume, at, step);
        for (int k = 0; k < volume.tile(at.x(), at.y()).count; ++k) {
            int best = least + jump_penalty(penalty, difference);
            for (int apart = -1; apart <= 1; ++apart) {
                const int p = k + beyond + apart;
                if (p < 0 || p >= before_count) continue;
                best = std::min(best, before[p] + std::abs(apart) * penalty.one_plane);
            }
            costs[volume.offset(at.x(), at.y()) + static_cast<std::size_t>(k)] += best - least;
        }
    }
    return costs;
}

void expect_brute_force_sums(const CostVolume& volume) {
    const GrayImage gray = random_gray(volume.height(), 7);
    const SmoothnessPenalty penalty;
    std::vector<int> expected(volume.costs().size());
    for (const auto& [x, y] :
         {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1), std::pair(1, 1),
          std::pair(-1, -1), std::pair(1, -1), std::pair(-1, 1)}) {
        const std::vector<int> along = path_costs(volume, gray, penalty, {x, y});
        std::transform(along.begin(), along.end(), expected.begin(), expected.begin(),
                       std::plus<>());
    }
    std::vector<std::uint16_t> sums{7};  // Of other work.
    aggregate_paths(volume, gray, penalty, sums);
    ASSERT_EQ(sums.size(), expected.size());
    for (int y = 0; y < volume.height(); ++y) {
        for (int x = 0; x < kWidth_px; ++x) {
            for (int k = 0; k < volume.tile(x, y).count; ++k) {
                const std::size_t i = volume.offset(x, y) + static_cast<std::size_t>(k);
                ASSERT_EQ(sums[i], expected[i]) << "pixel " << x << ' ' << y << " plane " << k;
            }
        }
    }
}

TEST(SemiGlobalMatching, OnARowEqualsDynamicProgrammingByDefinition) {
    expect_brute_force_sums(random_costs(1, {{0, 48}, {0, 48}, {0, 48}}, 1));
}

TEST(SemiGlobalMatching, TilesMayHaveDifferentRanges) {
    expect_brute_force_sums(random_costs(1, {{10, 32}, {3, 48}, {60, 16}}, 2));
    expect_brute_force_sums(random_costs(1, {{10, 8}, {3, 24}, {60, 40}}, 2));
}

TEST(SemiGlobalMatching, AlongAllEightPathsEqualsDynamicProgrammingByDefinition) {
    std::mt19937 random(9);
    for (const double steepest : {0.0, 1.0}) {
        std::uniform_real_distribution<double> slope(-steepest, steepest);
        for (unsigned trial = 0; trial < 3; ++trial) {
            std::vector<TilePlanes> tiles(6);  // The lower ones are cut.
            for (TilePlanes& tile : tiles) {
                tile = {static_cast<int>(random() % 40), 8 * static_cast<int>(1 + random() % 6)};
                if (steepest > 0) tile.slope = {slope(random), slope(random)};
            }
            expect_brute_force_sums(random_costs(21, tiles, trial));
        }
    }
}

TEST(SemiGlobalMatching, ASlopingTileContinuesItsSlopeInTheNext) {
    // Both tiles slope by one plane per pixel, and the second begins 16 planes on: one surface.
    CostVolume volume(32, 1, {{20, 16, {1, 0}}, {36, 16, {1, 0}}});
    std::fill(volume.costs().begin(), volume.costs().end(), std::uint8_t{20});
    for (int x = 0; x < 32; ++x) volume.costs()[volume.offset(x, 0) + 5] = 0;
    const GrayImage gray(32, 1, 128);
    std::vector<std::uint16_t> sums;
    const MatchedPlanes matched = semi_global_matching(volume, gray, {}, sums);
    for (int x = 0; x < 32; ++x) {
        EXPECT_EQ(sums[volume.offset(x, 0) + 5], 0) << "a smooth surface costs nothing, x " << x;
        EXPECT_FLOAT_EQ(matched.plane(x, 0), static_cast<float>(20 + 5 + x - 7.5)) << x;
    }
}

}  // namespace
}  // namespace lumi
