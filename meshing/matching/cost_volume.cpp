#include "meshing/matching/cost_volume.h"

#include <algorithm>
#include <cassert>

#include "calib/capture/inverse_depth_warp.h"
#include "meshing/matching/patch_matching.h"

namespace lumi {
namespace {

static_assert(kTileSide == kPatchTile);
static_assert(kMaxMatchingCost == 2 * kCensusBits);

/// What a neighbour contributes to every tile.
struct Comparison {
    InverseDepthWarp warp;
    PackedPicture picture;
};

/// The view's own patch around a tile; pixels beyond the border repeat it.
PatchArray<std::uint8_t> patch_of(const GrayImage& gray, int left, int top) {
    PatchArray<std::uint8_t> patch;
    std::size_t next = 0;
    for (int y = 0; y < kPatchSide; ++y) {
        const std::uint8_t* row =
            gray.row(std::clamp(top + y - kCensusRadius, 0, gray.height() - 1));
        for (int x = 0; x < kPatchSide; ++x) {
            patch[next++] = row[std::clamp(left + x - kCensusRadius, 0, gray.width() - 1)];
        }
    }
    return patch;
}

/// Copies the inner pixels of a patch to every `stride`-th byte of `out`.
void write_plane(const PatchArray<std::uint8_t>& cost, int stride, std::uint8_t* out) {
    for (int y = 0; y < kPatchTile; ++y) {
        const std::uint8_t* in = cost.data() + (y + kCensusRadius) * kPatchSide + kCensusRadius;
        for (int x = 0; x < kPatchTile; ++x, out += stride) *out = in[x];
    }
}

void write_means(const PatchArray<std::uint32_t>& sum, const PatchArray<std::uint32_t>& count,
                 int left, int top, CostVolume& volume) {
    for (int y = 0; y < kPatchTile && top + y < volume.height(); ++y) {
        for (int x = 0; x < kPatchTile && left + x < volume.width(); ++x) {
            const auto i =
                static_cast<std::size_t>((y + kCensusRadius) * kPatchSide + x + kCensusRadius);
            const std::uint32_t mean = sum[i] / std::max(1U, count[i]);
            volume.mean_seen_costs()(left + x, top + y) = static_cast<std::uint8_t>(mean);
        }
    }
}

/// Sweeps one tile and writes its costs, pixel by pixel.
void sweep_tile(const SweepView& view, const std::vector<Comparison>& comparisons,
                const SweepPlanes& planes, int left, int top, CostVolume& volume) {
    CensusPatch census;
    take_census(patch_of(view.gray, left, top), census);
    const TilePlanes& tile = volume.tile(left, top);
    const Eigen::Vector2d slope = planes.step * tile.slope;
    std::vector<PatchRays> rays;
    for (const Comparison& comparison : comparisons) {
        rays.push_back(patch_rays(comparison.warp, left, top, slope));
    }

    WarpedPatch warped;
    PatchArray<std::uint8_t> mismatches, best, second, cost;
    PatchArray<std::uint32_t> sum{}, count{};
    std::uint8_t* tile_costs = volume.costs().data() + volume.offset(left, top);
    for (int plane = 0; plane < tile.count; ++plane) {
        const double inverse_depth = planes.inverse_depth(tile.first + plane);
        best.fill(kNotSeen);
        second.fill(kNotSeen);
        for (std::size_t n = 0; n < comparisons.size(); ++n) {
            const Eigen::Vector3f shift =
                (inverse_depth * comparisons[n].warp.epipole).cast<float>();
            warp_patch(comparisons[n].picture, rays[n], shift.data(), warped);
            count_mismatches(warped.gray, census, mismatches);
            keep_two_best(mismatches, warped.hidden, best, second);
        }
        combine_best(best, second, cost);
        add_seen(best, cost, sum, count);
        write_plane(cost, tile.count, tile_costs + plane);
    }
    write_means(sum, count, left, top, volume);
}

}  // namespace

CostVolume::CostVolume(int width, int height, std::vector<TilePlanes> tiles,
                       std::vector<std::uint8_t> memory)
    : width_(width),
      height_(height),
      tiles_(std::move(tiles)),
      costs_(std::move(memory)),
      mean_seen_costs_(width, height) {
    assert(static_cast<int>(tiles_.size()) == tiles_along(width) * tiles_along(height));
    std::size_t total = 0;
    for (const TilePlanes& tile : tiles_) {
        assert(tile.count > 0);
        offsets_.push_back(total);
        total +=
            static_cast<std::size_t>(kTileSide * kTileSide) * static_cast<std::size_t>(tile.count);
        max_count_ = std::max(max_count_, tile.count);
    }
    if (costs_.capacity() < total)
        std::vector<std::uint8_t>().swap(costs_);  // Before more is taken.
    costs_.resize(total);
}

CostVolume sweep_costs(const SweepView& view, const std::vector<SweepView>& neighbours,
                       const SweepPlanes& planes, std::vector<TilePlanes> tiles,
                       std::vector<std::uint8_t> memory) {
    std::vector<Comparison> comparisons;
    for (const SweepView& other : neighbours) {
        comparisons.push_back({warp_from(view).to(other), packed(other.gray)});
    }
    CostVolume volume(view.gray.width(), view.gray.height(), std::move(tiles), std::move(memory));
    for (int top = 0; top < volume.height(); top += kTileSide) {
        for (int left = 0; left < volume.width(); left += kTileSide) {
            sweep_tile(view, comparisons, planes, left, top, volume);
        }
    }
    return volume;
}

}  // namespace lumi
