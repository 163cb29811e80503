#pragma once

#include <cstddef>
#include <vector>

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/matching/cost_volume.h"
#include "meshing/matching/tile_search.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// How many costs one level of a sweep may hold: 64 a pixel, but 4 million at least and 96 million
/// at most, or 32 a pixel where that is more.
[[nodiscard]] std::size_t sweep_cells_allowed(std::size_t pixels);

/// Where one level of a sweep looks.
struct SweepSearch {
    SweepPlanes planes;
    std::vector<TilePlanes> tiles;
    /// Whether pixels that a coarser level found beyond the planes of their tile are to stay as
    /// they were found.
    bool keeps_coarser = false;
};

/// As far around what was found, and then in as fine steps, as the memory allows. `spacing_px`: of
/// disparity at this level, between planes.
///
/// Where more is needed, the tiles with the widest ranges are searched around most of what was
/// found in them, and if that is not enough, all in coarser steps. In a picture so large that it
/// has but 32 cells a pixel, a few steep tiles would spoil all others: where `has_coarser` level
/// found what is searched around, steps are at most a pixel, and of the widest tiles the nearest
/// planes are searched alone.
[[nodiscard]] SweepSearch sweep_search(const DepthView& view, double level_scale, double spacing_px,
                                       const std::vector<TileSurface>& surfaces, bool has_coarser);

/// Gives pixels of `finer` that `coarser`, of half the size, found beyond the planes of their tile
/// back what was found there.
void keep_beyond_planes(const CostVolume& volume, const SweepPlanes& planes,
                        const DepthMap& coarser, DepthMap& finer);

}  // namespace lumi
