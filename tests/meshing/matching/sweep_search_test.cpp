#include "meshing/matching/sweep_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace lumi {
namespace {

DepthView wide_view(int width_px, int height_px) {
    DepthView view;
    view.camera = pinhole_camera(width_px, height_px, width_px);
    view.range = {0.0, 1.0};
    view.disparity_px_per_inverse_depth = 0.1 * width_px;
    return view;
}

/// A wall before another, half as far away again: all but one tile in so many show the one alone.
std::vector<TileSurface> walls(const DepthView& view, std::size_t outline_every) {
    const auto tiles = static_cast<std::size_t>(tiles_along(view.camera.width_px) *
                                                tiles_along(view.camera.height_px));
    std::vector<TileSurface> surfaces(tiles, TileSurface{{0.4, 0.4}});
    for (std::size_t i = 0; i < tiles; i += outline_every) surfaces[i] = TileSurface{{0.4, 0.6}};
    return surfaces;
}

std::size_t cells_in(const SweepSearch& search) {
    return std::accumulate(search.tiles.begin(), search.tiles.end(), std::size_t{0},
                           [](std::size_t sum, const TilePlanes& tile) {
                               return sum +
                                      static_cast<std::size_t>(tile.count) * kTileSide * kTileSide;
                           });
}

TEST(SweepSearch, OutlinesDoNotSpoilTheRestOfALargePicture) {
    for (const int width_px : {2600, 4608, 6000}) {
        const DepthView view = wide_view(width_px, width_px * 2 / 3);
        const auto pixels =
            static_cast<std::size_t>(width_px) * static_cast<std::size_t>(width_px * 2 / 3);
        const std::vector<TileSurface> surfaces = walls(view, 5);
        const SweepSearch search = sweep_search(view, 1.0, 0.75, surfaces, true);
        EXPECT_LE(search.planes.step * view.disparity_px_per_inverse_depth, 1.0) << width_px;
        EXPECT_LE(cells_in(search), sweep_cells_allowed(pixels) * 101 / 100) << width_px;
        for (std::size_t i = 0; i < search.tiles.size(); ++i) {
            const double first = search.planes.inverse_depth(search.tiles[i].first);
            const double last =
                search.planes.inverse_depth(search.tiles[i].first + search.tiles[i].count - 1);
            const double nearest = surfaces[i].at_centre.near;
            ASSERT_TRUE(first < nearest && nearest < last) << width_px << ", tile " << i;
        }
    }
}

TEST(SweepSearch, ALargePictureHasHalfOfTheCellsAPixelThatASmallOneHas) {
    EXPECT_EQ(sweep_cells_allowed(1'000'000), 64'000'000U);
    EXPECT_EQ(sweep_cells_allowed(3'000'000), std::size_t{96} << 20);
    EXPECT_EQ(sweep_cells_allowed(24'000'000), 768'000'000U);
    EXPECT_EQ(sweep_cells_allowed(100), std::size_t{4} << 20);
}

TEST(SweepSearch, TheWholeRangeIsSearchedWhereNothingWasFoundBefore) {
    const DepthView view = wide_view(2600, 1733);
    const std::vector<TileSurface> surfaces = search_whole_range(view.range, 2600, 1733, {});
    const SweepSearch search = sweep_search(view, 1.0, 1.0, surfaces, false);
    for (const TilePlanes& tile : search.tiles) {
        ASSERT_LE(search.planes.inverse_depth(tile.first), view.range.far);
        ASSERT_GE(search.planes.inverse_depth(tile.first + tile.count - 1), view.range.near);
    }
    EXPECT_FALSE(search.keeps_coarser);
}

TEST(SweepSearch, WhatLiesBeyondThePlanesOfATileStaysAsItWasFound) {
    const SweepPlanes planes{0.0, 0.01, 80};
    // Planes 40 to 47, as they stand in the middle; the second tile's rise by one in four pixels.
    const CostVolume volume(32, 16, {{40, 8, {0, 0}}, {40, 8, {0.25, 0}}});
    DepthMap coarser{FloatImage(16, 8, 0.45F), GrayImage(16, 8, 0)};
    coarser.inverse_depth(2, 3) = 0.2F;
    coarser.confidence(2, 3) = 255;
    coarser.inverse_depth(9, 3) = 0.4F;   // Plane 40, where the tile's first is 38.5.
    coarser.inverse_depth(15, 3) = 0.4F;  // And where it is 41.6.
    DepthMap finer{FloatImage(32, 16, 0.44F), GrayImage(32, 16, 128)};
    keep_beyond_planes(volume, planes, coarser, finer);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 32; ++x) {
            const bool is_beyond = y / 2 == 3 && (x / 2 == 2 || x / 2 == 15);
            const float found = coarser.inverse_depth(x / 2, y / 2);
            ASSERT_EQ(finer.inverse_depth(x, y), is_beyond ? found : 0.44F) << x << " " << y;
            ASSERT_EQ(finer.confidence(x, y), is_beyond ? coarser.confidence(x / 2, y / 2) : 128);
        }
    }
}

}  // namespace
}  // namespace lumi
