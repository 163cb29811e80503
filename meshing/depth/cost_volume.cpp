#include "meshing/depth/cost_volume.h"

#include <algorithm>
#include <cassert>

#include "meshing/depth/inverse_depth_warp.h"
#include "meshing/depth/patch_matching.h"

namespace lumi {
namespace {

static_assert(CostVolume::kTile == kPatchTile);
static_assert(kMaxMatchingCost == 2 * kCensusBits);

int tiles_along(int pixels) { return (pixels + CostVolume::kTile - 1) / CostVolume::kTile; }

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

/// Sweeps one tile and writes its costs, pixel by pixel.
void sweep_tile(const SweepView& view, const std::vector<Comparison>& comparisons,
                const SweepPlanes& planes, int left, int top, CostVolume& volume) {
    CensusPatch census;
    take_census(patch_of(view.gray, left, top), census);
    std::vector<PatchRays> rays;
    for (const Comparison& comparison : comparisons) {
        rays.push_back(patch_rays(comparison.warp, left, top));
    }
    const PlaneRange range = volume.range(left, top);
    WarpedPatch warped;
    PatchArray<std::uint8_t> mismatches, best, second, cost;
    std::uint8_t* tile_costs = volume.costs().data() + volume.offset(left, top);
    for (int plane = 0; plane < range.count; ++plane) {
        const double inverse_depth = planes.inverse_depth(range.first + plane);
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
        std::uint8_t* out = tile_costs + plane;
        for (int y = 0; y < kPatchTile; ++y) {
            const std::uint8_t* in = cost.data() + (y + kCensusRadius) * kPatchSide + kCensusRadius;
            for (int x = 0; x < kPatchTile; ++x, out += range.count) *out = in[x];
        }
    }
}

}  // namespace

int tile_count(int width, int height) { return tiles_along(width) * tiles_along(height); }

CostVolume::CostVolume(int width, int height, std::vector<PlaneRange> ranges)
    : width_(width),
      height_(height),
      tiles_across_(tiles_along(width)),
      tiles_down_(tiles_along(height)),
      ranges_(std::move(ranges)) {
    assert(static_cast<int>(ranges_.size()) == tile_count(width, height));
    std::size_t total = 0;
    for (const PlaneRange& range : ranges_) {
        assert(range.count > 0);
        offsets_.push_back(total);
        total += static_cast<std::size_t>(kTile) * kTile * static_cast<std::size_t>(range.count);
        max_count_ = std::max(max_count_, range.count);
    }
    costs_.resize(total);
}

CostVolume sweep_costs(const SweepView& view, const std::vector<SweepView>& neighbours,
                       const SweepPlanes& planes, std::vector<PlaneRange> ranges) {
    std::vector<Comparison> comparisons;
    for (const SweepView& other : neighbours) {
        comparisons.push_back(
            {warp_b_from_a(view.camera, view.cam_from_world, other.camera, other.cam_from_world),
             packed(other.gray)});
    }
    CostVolume volume(view.gray.width(), view.gray.height(), std::move(ranges));
    for (int top = 0; top < volume.height(); top += CostVolume::kTile) {
        for (int left = 0; left < volume.width(); left += CostVolume::kTile) {
            sweep_tile(view, comparisons, planes, left, top, volume);
        }
    }
    return volume;
}

}  // namespace lumi
