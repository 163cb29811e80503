#include "meshing/matching/patch_matching.h"

#include <algorithm>
#include <cstring>

#include "meshing/warp/instruction_sets.h"

namespace lumi {
namespace {

constexpr int kCensusThreshold = 1;
constexpr int kSubpixelBits = 6;
constexpr int kInnerBegin = kCensusRadius * kPatchSide + kCensusRadius;
constexpr int kInnerEnd = kPatchPixels - kInnerBegin;

constexpr std::array<int, kCensusBits> census_offsets() {
    std::array<int, kCensusBits> offsets{};
    std::size_t next = 0;
    for (int dy = -kCensusRadius; dy <= kCensusRadius; ++dy) {
        for (int dx = -kCensusRadius; dx <= kCensusRadius; ++dx) {
            if (dx != 0 || dy != 0) offsets[next++] = dy * kPatchSide + dx;
        }
    }
    return offsets;
}
constexpr std::array<int, kCensusBits> kCensusOffsets = census_offsets();

// Kernels work on plain pointers: the vectoriser then knows what aliases and what does not.

/// Where each pixel is sampled, and how: grey values between four pixels, in 1/64 pixel. Sixty-four
/// pixels at a time; the last block overlaps the one before it.
struct WarpPixels {
    static constexpr int kLanes = 64;

    LUMI_KERNEL void run(const std::uint32_t* quads, int width, int height,
                         const float* __restrict ray_x, const float* __restrict ray_y,
                         const float* __restrict ray_z, const float* shift,
                         std::uint8_t* __restrict gray, std::uint8_t* __restrict hidden) {
        const float max_u = static_cast<float>((width - 1) << kSubpixelBits);
        const float max_v = static_cast<float>((height - 1) << kSubpixelBits);
        constexpr float kSubpixels = 1 << kSubpixelBits;
        constexpr int kOne = 1 << kSubpixelBits;
        const float shift_x = shift[0];
        const float shift_y = shift[1];
        const float shift_z = shift[2];
        for (int block = 0; block < kPatchPixels; block += kLanes) {
            const int begin = block + kLanes <= kPatchPixels ? block : kPatchPixels - kLanes;
            int index[kLanes];
            std::uint32_t right[kLanes], down[kLanes];
            for (int i = 0; i < kLanes; ++i) {
                const float z = ray_z[begin + i] + shift_z;
                const float scale = kSubpixels / z;
                const float u = (ray_x[begin + i] + shift_x) * scale - 0.5F * kSubpixels;
                const float v = (ray_y[begin + i] + shift_y) * scale - 0.5F * kSubpixels;
                const int inside = (z > 1e-6F) & (u >= 0) & (u <= max_u) & (v >= 0) & (v <= max_v);
                // A pixel that is not inside reads the corner: in bounds, and never used.
                const int fixed_u = static_cast<int>(inside != 0 ? u : 0.0F);
                const int fixed_v = static_cast<int>(inside != 0 ? v : 0.0F);
                index[i] = (fixed_v >> kSubpixelBits) * width + (fixed_u >> kSubpixelBits);
                right[i] = static_cast<std::uint32_t>(fixed_u & (kOne - 1));
                down[i] = static_cast<std::uint32_t>(fixed_v & (kOne - 1));
                hidden[begin + i] = static_cast<std::uint8_t>(inside != 0 ? 0 : kNotSeen);
            }
            for (int i = 0; i < kLanes; ++i) index[i] = static_cast<int>(quads[index[i]]);
            for (int i = 0; i < kLanes; ++i) {
                // Upper and lower row at once, in the halves of a word: each stays below 2^16.
                const auto quad = static_cast<std::uint32_t>(index[i]);
                const std::uint32_t left_pixels = quad & 0x00FF00FFU;
                const std::uint32_t right_pixels = (quad >> 8) & 0x00FF00FFU;
                const std::uint32_t rows =
                    (left_pixels << kSubpixelBits) + right[i] * (right_pixels - left_pixels);
                const std::uint32_t upper = rows & 0xFFFFU;
                const std::uint32_t lower = rows >> 16;
                const std::uint32_t value = (upper << kSubpixelBits) + down[i] * (lower - upper);
                gray[begin + i] =
                    static_cast<std::uint8_t>((value + kOne * kOne / 2) >> (2 * kSubpixelBits));
            }
        }
    }
};

struct CensusPixels {
    LUMI_KERNEL void run(const std::uint8_t* __restrict gray, int offset,
                         std::uint8_t* __restrict bits) {
        for (int i = kInnerBegin; i < kInnerEnd; ++i) {
            const bool is_brighter = gray[i + offset] > gray[i] + kCensusThreshold;
            bits[i] = static_cast<std::uint8_t>(is_brighter ? 255 : 0);
        }
    }
};

/// Sixty-four pixels at a time; the last block overlaps the one before it.
struct MismatchPixels {
    static constexpr int kLanes = 64;
    using Bytes [[gnu::vector_size(kLanes)]] = std::uint8_t;

    LUMI_KERNEL void run(const std::uint8_t* gray, const CensusPatch* reference,
                         std::uint8_t* mismatches) {
        for (int begin = kInnerBegin; begin < kInnerEnd; begin += kLanes) {
            const int i = begin + kLanes <= kInnerEnd ? begin : kInnerEnd - kLanes;
            Bytes centre;
            std::memcpy(&centre, gray + i, kLanes);
            // Of 255 nothing is brighter.
            const Bytes brightest = centre < 255 - kCensusThreshold
                                        ? centre + std::uint8_t{kCensusThreshold}
                                        : Bytes{} + std::uint8_t{255};
            Bytes sum{};
            for (std::size_t bit = 0; bit < kCensusOffsets.size(); ++bit) {
                Bytes neighbour, expected;
                std::memcpy(&neighbour, gray + i + kCensusOffsets[bit], kLanes);
                std::memcpy(&expected, reference->is_brighter[bit].data() + i, kLanes);
                const auto is_brighter = __builtin_convertvector(neighbour > brightest, Bytes);
                sum -= is_brighter ^ expected;  // 255 is -1.
            }
            std::memcpy(mismatches + i, &sum, kLanes);
        }
    }
};

struct TwoBestPixels {
    LUMI_KERNEL void run(const std::uint8_t* __restrict mismatches,
                         const std::uint8_t* __restrict hidden, std::uint8_t* __restrict best,
                         std::uint8_t* __restrict second) {
        for (int i = kInnerBegin; i < kInnerEnd; ++i) {
            const auto cost = static_cast<std::uint8_t>(mismatches[i] | hidden[i]);
            const std::uint8_t worse = best[i] > cost ? best[i] : cost;
            best[i] = best[i] < cost ? best[i] : cost;
            second[i] = second[i] < worse ? second[i] : worse;
        }
    }
};

struct CombinedPixels {
    LUMI_KERNEL void run(const std::uint8_t* __restrict best, const std::uint8_t* __restrict second,
                         std::uint8_t* __restrict cost) {
        for (int i = kInnerBegin; i < kInnerEnd; ++i) {
            const std::uint8_t other = second[i] == kNotSeen ? best[i] : second[i];
            const auto sum = static_cast<std::uint8_t>(best[i] + other);
            cost[i] = best[i] == kNotSeen ? kUnseenCost : sum;
        }
    }
};

struct AddSeenPixels {
    LUMI_KERNEL void run(const std::uint8_t* __restrict best, const std::uint8_t* __restrict cost,
                         std::uint32_t* __restrict sum, std::uint32_t* __restrict count) {
        for (int i = kInnerBegin; i < kInnerEnd; ++i) {
            const std::uint32_t is_seen = best[i] != kNotSeen ? 1 : 0;
            sum[i] += is_seen * cost[i];
            count[i] += is_seen;
        }
    }
};

}  // namespace

PackedPicture packed(const GrayImage& picture) {
    PackedPicture result{picture.width(), picture.height(), {}};
    result.quads.resize(picture.pixels().size());
    std::size_t next = 0;
    for (int y = 0; y < picture.height(); ++y) {
        const std::uint8_t* upper = picture.row(y);
        const std::uint8_t* lower = picture.row(std::min(y + 1, picture.height() - 1));
        for (int x = 0; x < picture.width(); ++x) {
            const int right = std::min(x + 1, picture.width() - 1);
            result.quads[next++] = std::uint32_t{upper[x]} | std::uint32_t{upper[right]} << 8 |
                                   std::uint32_t{lower[x]} << 16 |
                                   std::uint32_t{lower[right]} << 24;
        }
    }
    return result;
}

PatchRays patch_rays(const InverseDepthWarp& warp, int left, int top,
                     const Eigen::Vector2d& slope) {
    PatchRays rays;
    const Eigen::Vector2d centre(left + 0.5 * kPatchTile, top + 0.5 * kPatchTile);
    std::size_t next = 0;
    for (int y = 0; y < kPatchSide; ++y) {
        for (int x = 0; x < kPatchSide; ++x, ++next) {
            const Eigen::Vector2d pixel(left + x - kCensusRadius + 0.5,
                                        top + y - kCensusRadius + 0.5);
            const Eigen::Vector3d ray = warp.homogeneous_at(pixel, slope.dot(pixel - centre));
            rays.x[next] = static_cast<float>(ray.x());
            rays.y[next] = static_cast<float>(ray.y());
            rays.z[next] = static_cast<float>(ray.z());
        }
    }
    return rays;
}

void warp_patch(const PackedPicture& picture, const PatchRays& rays, const float shift[3],
                WarpedPatch& warped) {
    run_fastest<WarpPixels>(picture.quads.data(), picture.width, picture.height, rays.x.data(),
                            rays.y.data(), rays.z.data(), shift, warped.gray.data(),
                            warped.hidden.data());
}

void take_census(const PatchArray<std::uint8_t>& gray, CensusPatch& census) {
    for (std::size_t bit = 0; bit < kCensusOffsets.size(); ++bit) {
        run_fastest<CensusPixels>(gray.data(), kCensusOffsets[bit], census.is_brighter[bit].data());
    }
}

void count_mismatches(const PatchArray<std::uint8_t>& gray, const CensusPatch& reference,
                      PatchArray<std::uint8_t>& mismatches) {
    run_fastest<MismatchPixels>(gray.data(), &reference, mismatches.data());
}

void keep_two_best(const PatchArray<std::uint8_t>& mismatches,
                   const PatchArray<std::uint8_t>& hidden, PatchArray<std::uint8_t>& best,
                   PatchArray<std::uint8_t>& second) {
    run_fastest<TwoBestPixels>(mismatches.data(), hidden.data(), best.data(), second.data());
}

void combine_best(const PatchArray<std::uint8_t>& best, const PatchArray<std::uint8_t>& second,
                  PatchArray<std::uint8_t>& cost) {
    run_fastest<CombinedPixels>(best.data(), second.data(), cost.data());
}

void add_seen(const PatchArray<std::uint8_t>& best, const PatchArray<std::uint8_t>& cost,
              PatchArray<std::uint32_t>& sum, PatchArray<std::uint32_t>& count) {
    run_fastest<AddSeenPixels>(best.data(), cost.data(), sum.data(), count.data());
}

}  // namespace lumi
