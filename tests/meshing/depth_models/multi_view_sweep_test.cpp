#include "meshing/depth_models/multi_view_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meshing/matching/tile_search.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

DepthMap swept(const KnownDepthScene& known) {
    SweepMemory memory{std::vector<std::uint8_t>(99, 5), {3, 4}};  // As another sweep left it.
    return multi_view_sweep(known.scene, 0, memory);
}

constexpr int kMargin = 16;  // Pixels at the border that most neighbours do not see.

double share_within(const FloatImage& errors, float limit_px) {
    int within = 0;
    int all = 0;
    for (int y = kMargin; y < errors.height() - kMargin; ++y) {
        for (int x = kMargin; x < errors.width() - kMargin; ++x) {
            ++all;
            if (errors(x, y) <= limit_px) ++within;
        }
    }
    return static_cast<double>(within) / all;
}

TEST(MultiViewSweep, FindsASlantedWallToAFractionOfAPixel) {
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 2}, {0.5, 0.4, 1}, [](const auto&) { return true; }, noise_texture(0.03, 5)}},
        cross_of_centres(0.12), {0.1, 1.2});
    const DepthMap map = swept(known);
    const FloatImage errors = errors_px(map, known.inverse_depths[0], known.scene.views[0]);
    EXPECT_GT(share_within(errors, 0.5F), 0.97);
    EXPECT_GT(share_within(errors, 0.2F), 0.90) << "no staircase";
}

TEST(MultiViewSweep, FindsTheSameInMillimetresAndKilometres) {
    const auto wall = [](double unit) {
        const auto texture = noise_texture(0.03, 5);
        return known_depth_scene({{{0, 0, 2 * unit},
                                   {0.5, 0.4, 1},
                                   [](const auto&) { return true; },
                                   [=](const Eigen::Vector3d& p) { return texture(p / unit); }}},
                                 cross_of_centres(0.12 * unit), {0.1 / unit, 1.2 / unit});
    };
    for (const double unit : {1e-6, 1e6}) {
        const KnownDepthScene known = wall(unit);
        const FloatImage errors =
            errors_px(swept(known), known.inverse_depths[0], known.scene.views[0]);
        EXPECT_GT(share_within(errors, 0.5F), 0.97) << unit;
    }
}

TEST(MultiViewSweep, BlursAStepByNoMoreThanItsWindow) {
    // A board in the left half before a wall: 15 pixels of disparity between them.
    const auto board = [](const Eigen::Vector3d& p) { return p.x() < 0; };
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 3}, {0, 0, 1}, [](const auto&) { return true; }, noise_texture(0.04, 5)},
         {{0, 0, 1.5}, {0, 0, 1}, board, noise_texture(0.02, 8)}},
        cross_of_centres(0.2), {0.1, 1.0});
    const FloatImage errors =
        errors_px(swept(known), known.inverse_depths[0], known.scene.views[0]);
    int wrong_near = 0;
    int wrong_far = 0;
    for (int y = 2 * kMargin; y < errors.height() - 2 * kMargin; ++y) {
        for (int x = 2 * kMargin; x < errors.width() - 2 * kMargin; ++x) {
            if (errors(x, y) <= 1.0F) continue;
            ++(std::abs(x - 120) <= 5 ? wrong_near : wrong_far);
        }
    }
    const int rows = errors.height() - 4 * kMargin;
    EXPECT_LT(wrong_near, 3 * rows) << "pixels a row that the edge is fattened by";
    EXPECT_LT(wrong_far, rows / 10);
}

TEST(MultiViewSweep, ClaimsNothingWhereThereIsNoTexture) {
    const KnownDepthScene known = known_depth_scene({{{0, 0, 2},
                                                      {0.3, 0, 1},
                                                      [](const auto&) { return true; },
                                                      [](const auto&) { return 128.0; }}},
                                                    cross_of_centres(0.12), {0.1, 1.2});
    const DepthMap map = swept(known);
    EXPECT_EQ(map.confidence, GrayImage(240, 180, 0));
    for (const float value : map.inverse_depth.pixels()) ASSERT_TRUE(std::isfinite(value));
}

TEST(TileSearch, AMismatchWidensItsOwnTileAloneButASurfaceItsNeighboursToo) {
    FloatImage found(48, 48, 0.5F);
    found(20, 20) = 3.0F;
    const auto near_of = [&](std::size_t tile) {
        return search_around(found, 48, 48, 0.01)[tile].at_centre.near;
    };
    EXPECT_NEAR(near_of(4), 3.0, 1e-5);
    for (const std::size_t tile : {0U, 1U, 2U, 3U, 5U, 6U, 7U, 8U}) {
        EXPECT_NEAR(near_of(tile), 0.5, 1e-5) << tile;
    }
    // A pole, four pixels wide, beside the first column of tiles.
    for (int y = 0; y < 48; ++y) {
        for (int x = 18; x < 22; ++x) found(x, y) = 1.0F;
    }
    EXPECT_NEAR(near_of(0), 1.0, 1e-5);
}

TEST(TileSearch, TheCoreOfATileIsWhatMostOfItShows) {
    FloatImage found(48, 48, 0.5F);
    for (int y = 0; y < 48; ++y) {
        for (int x = 22; x < 26; ++x) found(x, y) = 1.0F;  // An eighth of what the tile asks.
    }
    const TileSurface tile = search_around(found, 48, 48, 0.01)[4];
    EXPECT_NEAR(tile.at_centre.near, 1.0, 1e-5);
    EXPECT_NEAR(tile.core.near, 0.5, 1e-5);
    EXPECT_NEAR(tile.core.far, 0.5, 1e-5);
}

}  // namespace
}  // namespace lumi
