#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "calib/capture/image.h"
#include "calib/capture/inverse_depth_warp.h"

namespace lumi {

/// How well square patches of one view fit another at a given inverse depth: the inner loops of
/// the plane sweep. Rasters are flat arrays so that the compiler can vectorise them.

constexpr int kPatchTile = 16;    ///< Pixels a side for which costs are wanted.
constexpr int kCensusRadius = 2;  ///< The census window is 5x5.
constexpr int kCensusBits = 24;
constexpr int kPatchSide = kPatchTile + 2 * kCensusRadius;
constexpr int kPatchPixels = kPatchSide * kPatchSide;

template <class Value>
using PatchArray = std::array<Value, static_cast<std::size_t>(kPatchPixels)>;

/// A picture with each pixel's 2x2 neighbourhood packed into 32 bits, low byte top-left: one read
/// gives all that bilinear interpolation needs.
struct PackedPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> quads;
};
[[nodiscard]] PackedPicture packed(const GrayImage& picture);

/// Where each pixel of a patch appears, but for the inverse depth at the centre of its tile: the
/// rest of the warp and what a sloping plane adds to it.
struct PatchRays {
    PatchArray<float> x, y, z;
};
[[nodiscard]] PatchRays patch_rays(const InverseDepthWarp& warp, int left, int top,
                                   const Eigen::Vector2d& slope);

constexpr std::uint8_t kNotSeen = 255;

/// A patch of another view, as seen from this one.
struct WarpedPatch {
    PatchArray<std::uint8_t> gray;
    PatchArray<std::uint8_t> hidden;  ///< kNotSeen outside the other view's picture, else 0.
};

/// Samples the other view where the patch's pixels at one inverse depth appear: bilinear, in 1/64
/// pixel. `shift` is inverse_depth * epipole.
void warp_patch(const PackedPicture& picture, const PatchRays& rays, const float shift[3],
                WarpedPatch& warped);

/// One bit a neighbour: is it brighter than the centre by more than kCensusThreshold grey levels?
/// (Zabih and Woodfill 1994; the threshold keeps sensor noise from looking like texture.)
struct CensusPatch {
    std::array<PatchArray<std::uint8_t>, kCensusBits> is_brighter;  ///< 0 or 255.
};
void take_census(const PatchArray<std::uint8_t>& gray, CensusPatch& census);

/// Census bits of `gray` that differ from `reference`, 0 to 24, for the pixels at least
/// kCensusRadius from the patch's border.
void count_mismatches(const PatchArray<std::uint8_t>& gray, const CensusPatch& reference,
                      PatchArray<std::uint8_t>& mismatches);

/// Keeps the two smallest counts of each pixel over the views compared so far; start with kNotSeen.
void keep_two_best(const PatchArray<std::uint8_t>& mismatches,
                   const PatchArray<std::uint8_t>& hidden, PatchArray<std::uint8_t>& best,
                   PatchArray<std::uint8_t>& second);

/// What a pixel costs that no neighbour sees: as much as chance, whatever the depth.
constexpr std::uint8_t kUnseenCost = kCensusBits;

/// Sum of the two best counts, 0 to 2 * kCensusBits: a pixel hidden from some views is judged by
/// those that see it. With one view, its count twice; with none, kUnseenCost.
void combine_best(const PatchArray<std::uint8_t>& best, const PatchArray<std::uint8_t>& second,
                  PatchArray<std::uint8_t>& cost);

/// Adds the costs of the pixels that some neighbour saw to `sum`, and one to `count`.
void add_seen(const PatchArray<std::uint8_t>& best, const PatchArray<std::uint8_t>& cost,
              PatchArray<std::uint32_t>& sum, PatchArray<std::uint32_t>& count);

}  // namespace lumi
