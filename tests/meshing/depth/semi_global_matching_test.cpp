#include "meshing/matching/semi_global_matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lumi {
namespace {

constexpr int kStripWidth_px = 45;  // Three tiles, the last one cut.

CostVolume random_row(std::vector<TilePlanes> tiles, unsigned seed) {
    CostVolume volume(kStripWidth_px, 1, std::move(tiles));
    std::mt19937 random(seed);
    for (std::uint8_t& cost : volume.costs()) {
        cost = static_cast<std::uint8_t>(random() % (kMaxMatchingCost + 1));
    }
    return volume;
}

GrayImage random_gray(unsigned seed) {
    GrayImage gray(kStripWidth_px, 1);
    std::mt19937 random(seed);
    for (std::uint8_t& value : gray.pixels()) value = static_cast<std::uint8_t>(random() % 256);
    return gray;
}

int jump_penalty(const SmoothnessPenalty& penalty, int difference) {
    return static_cast<int>(
        std::lround(penalty.jump_at_edge + std::exp(-difference / penalty.edge_gray) *
                                               (penalty.jump - penalty.jump_at_edge)));
}

/// Hirschmueller's recurrence by its definition, over absolute planes.
std::vector<std::vector<int>> path_costs(const CostVolume& volume, const GrayImage& gray,
                                         const SmoothnessPenalty& penalty, int step) {
    std::vector<std::vector<int>> costs(kStripWidth_px);
    for (int i = 0; i < kStripWidth_px; ++i) {
        const int x = step > 0 ? i : kStripWidth_px - 1 - i;
        const TilePlanes& tile = volume.tile(x, 0);
        const std::uint8_t* own = volume.costs().data() + volume.offset(x, 0);
        auto& current = costs[static_cast<std::size_t>(x)];
        for (int k = 0; k < tile.count; ++k) {
            int smooth = 0;
            if (i > 0) {
                const auto& previous = costs[static_cast<std::size_t>(x - step)];
                const TilePlanes& from = volume.tile(x - step, 0);
                const int least = *std::min_element(previous.begin(), previous.end());
                int best = least + jump_penalty(penalty, std::abs(gray(x, 0) - gray(x - step, 0)));
                for (int p = 0; p < from.count; ++p) {
                    const int apart = std::abs(from.first + p - tile.first - k);
                    if (apart > 1) continue;
                    best = std::min(
                        best, previous[static_cast<std::size_t>(p)] + apart * penalty.one_plane);
                }
                smooth = best - least;
            }
            current.push_back(own[k] + smooth);
        }
    }
    return costs;
}

void expect_brute_force_sums(const CostVolume& volume) {
    const GrayImage gray = random_gray(7);
    const SmoothnessPenalty penalty;
    const auto forwards = path_costs(volume, gray, penalty, +1);
    const auto backwards = path_costs(volume, gray, penalty, -1);
    std::vector<std::uint16_t> sums{7};  // Of other work.
    aggregate_paths(volume, gray, penalty, sums);
    for (int x = 0; x < kStripWidth_px; ++x) {
        for (int k = 0; k < volume.tile(x, 0).count; ++k) {
            const auto index = volume.offset(x, 0) + static_cast<std::size_t>(k);
            // The six paths that leave the row have only just begun.
            const int expected =
                forwards[static_cast<std::size_t>(x)][static_cast<std::size_t>(k)] +
                backwards[static_cast<std::size_t>(x)][static_cast<std::size_t>(k)] +
                6 * volume.costs()[index];
            ASSERT_EQ(sums[index], expected) << "pixel " << x << " plane " << k;
        }
    }
}

TEST(SemiGlobalMatching, OnARowEqualsDynamicProgrammingByDefinition) {
    expect_brute_force_sums(random_row({{0, 48}, {0, 48}, {0, 48}}, 1));
}

TEST(SemiGlobalMatching, TilesMayHaveDifferentRanges) {
    expect_brute_force_sums(random_row({{10, 32}, {3, 48}, {60, 16}}, 2));
    expect_brute_force_sums(random_row({{10, 8}, {3, 24}, {60, 40}}, 2));
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
