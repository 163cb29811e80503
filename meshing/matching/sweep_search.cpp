#include "meshing/matching/sweep_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lumi {
namespace {

constexpr int kCountUnit = 8;  // The path kernel works on this many planes at a time.
constexpr std::size_t kMaxCells = std::size_t{96} << 20;
constexpr std::size_t kMaxCellsPerPixel = 64;
constexpr std::size_t kSureCellsPerPixel = 32;            // Of large pictures.
constexpr std::size_t kFreeCells = std::size_t{4} << 20;  // Of small pictures.

/// Planes `spacing_px` of disparity apart over the view's range, or farther: integers count them.
SweepPlanes planes_over(const DepthView& view, double level_scale, double spacing_px) {
    constexpr double kMostPlanes = 1 << 24;
    const double span = view.range.near - view.range.far;
    const double step = std::max(spacing_px / (view.disparity_px_per_inverse_depth * level_scale),
                                 span / kMostPlanes);
    const int needed = static_cast<int>(std::ceil(span / step)) + 1;
    const int units = std::max(1, (needed + kCountUnit - 1) / kCountUnit);
    return {view.range.far, step, units * kCountUnit};
}

/// The planes of a tile, rounded up to whole units within the sweep.
TilePlanes planes_of(const InverseDepthRange& range, const Eigen::Vector2d& slope,
                     const SweepPlanes& planes, double margin) {
    const double low = std::floor(planes.plane_at(range.far) - margin);
    const double high = std::ceil(planes.plane_at(range.near) + margin);
    const auto first = static_cast<int>(std::clamp(low, 0.0, planes.count - 1.0));
    const auto last = static_cast<int>(std::clamp(high, 1.0 * first, planes.count - 1.0));
    const int units = (last - first + kCountUnit) / kCountUnit;
    const int spare = units * kCountUnit - (last - first + 1);
    const int begin = std::clamp(first - spare / 2, 0, planes.count - units * kCountUnit);
    return {begin, units * kCountUnit, slope / planes.step};
}

constexpr std::size_t pixels_of(std::size_t tiles) { return tiles * kTileSide * kTileSide; }

/// With no more than `most` planes in any of them.
std::size_t cells_of(const std::vector<TilePlanes>& tiles, int most) {
    std::size_t cells = 0;
    for (const TilePlanes& tile : tiles) {
        cells += static_cast<std::size_t>(std::min(tile.count, most)) * pixels_of(1);
    }
    return cells;
}

std::size_t cells_of(const std::vector<TilePlanes>& tiles) {
    return cells_of(tiles, std::numeric_limits<int>::max());
}

/// Leaves the widest tiles their cores until `allowed` cells are enough, or all have.
void narrow(const std::vector<TilePlanes>& cores, std::size_t allowed,
            std::vector<TilePlanes>& tiles) {
    std::vector<std::size_t> order(tiles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto saved = [&](std::size_t i) { return tiles[i].count - cores[i].count; };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return saved(a) > saved(b); });
    std::size_t cells = cells_of(tiles);
    for (const std::size_t i : order) {
        if (cells <= allowed || saved(i) <= 0) return;
        cells -= static_cast<std::size_t>(saved(i)) * pixels_of(1);
        tiles[i] = cores[i];
    }
}

/// Leaves the widest tiles their nearest planes, all equally many, so that `allowed` cells are
/// enough: what is in front has the outlines.
void cut_to_nearest(std::size_t allowed, std::vector<TilePlanes>& tiles) {
    if (cells_of(tiles) <= allowed) return;
    int most = kCountUnit;
    while (cells_of(tiles, most + kCountUnit) <= allowed) most += kCountUnit;
    for (TilePlanes& tile : tiles) {
        if (tile.count <= most) continue;
        tile.first += tile.count - most;
        tile.count = most;
    }
}

}  // namespace

std::size_t sweep_cells_allowed(std::size_t pixels) {
    return std::clamp(kMaxCellsPerPixel * pixels, kFreeCells,
                      std::max(kMaxCells, kSureCellsPerPixel * pixels));
}

SweepSearch sweep_search(const DepthView& view, double level_scale, double spacing_px,
                         const std::vector<TileSurface>& surfaces, bool has_coarser) {
    constexpr double kMarginPx = 2.0;
    constexpr double kCoarser = 1.25;
    constexpr double kCoarsestPx = 1.0;  // Of large pictures.
    const std::size_t pixels = pixels_of(surfaces.size());
    const std::size_t allowed = sweep_cells_allowed(pixels);
    const bool keeps_coarser = has_coarser && kSureCellsPerPixel * pixels > kMaxCells;
    for (;; spacing_px *= kCoarser) {
        SweepSearch search{planes_over(view, level_scale, spacing_px), {}, keeps_coarser};
        const double margin = std::max(2.0, kMarginPx / spacing_px);
        std::vector<TilePlanes> cores;
        for (const TileSurface& surface : surfaces) {
            search.tiles.push_back(
                planes_of(surface.at_centre, surface.slope, search.planes, margin));
            cores.push_back(planes_of(surface.core, surface.slope, search.planes, margin));
        }
        narrow(cores, allowed, search.tiles);
        if (keeps_coarser && kCoarser * spacing_px > kCoarsestPx) {
            cut_to_nearest(allowed, search.tiles);
        }
        const bool is_coarsest = search.planes.count == kCountUnit;
        if (is_coarsest || cells_of(search.tiles) <= allowed) return search;
    }
}

void keep_beyond_planes(const CostVolume& volume, const SweepPlanes& planes,
                        const DepthMap& coarser, DepthMap& finer) {
    for (int y = 0; y < finer.confidence.height(); ++y) {
        const int coarse_y = std::min(y / 2, coarser.confidence.height() - 1);
        for (int x = 0; x < finer.confidence.width(); ++x) {
            const int coarse_x = std::min(x / 2, coarser.confidence.width() - 1);
            const float found = coarser.inverse_depth(coarse_x, coarse_y);
            const double plane =
                planes.plane_at(static_cast<double>(found)) - volume.first_plane(x, y);
            if (plane >= -1 && plane <= volume.tile(x, y).count) continue;
            finer.inverse_depth(x, y) = found;
            finer.confidence(x, y) = coarser.confidence(coarse_x, coarse_y);
        }
    }
}

}  // namespace lumi
