#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshing/surface/depth_map.h"
#include "render/lumigraph/depth_mesh.h"

namespace lumi {

/// A depth map as rays are looked for in it (depth_search.h): neighbours lie together in memory,
/// and of each square of samples it is known between which inverse depths they lie, so that what is
/// far from a ray is passed without being read.
class TiledDepth {
 public:
    /// Samples along a side of a square, of which there are two sizes.
    static constexpr int kFine = 4;
    static constexpr int kCoarse = 16;

    struct Sample {
        float inverse_depth;
        DepthKind kind;  ///< Seen or filled.
        bool is_torn;    ///< What lies to the right and below is not one surface.
    };
    /// Inverse depths in a square and one sample around it: of all that surfaces within it are
    /// interpolated with.
    struct Range {
        float farthest;
        float nearest;
    };

    TiledDepth() = default;
    /// All pictures of one size, as `validate` (lumigraph.h) wants them, or empty. `torn_squares`
    /// as from the function of this name (surface_tears.h).
    TiledDepth(const DepthMap& depth, const GrayImage& torn_squares);

    [[nodiscard]] bool empty() const { return width_ == 0; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    /// The largest inverse depth of all samples, and the smallest; 0 when there is none.
    [[nodiscard]] float nearest() const { return nearest_; }
    [[nodiscard]] float farthest() const { return farthest_; }

    /// Offsets of a row and of a column in the tiled memory: their sum is a sample's place.
    [[nodiscard]] std::size_t row_offset(int y) const {
        const auto row = static_cast<std::size_t>(y);
        return row / kSide * fine_columns_ * kSide * kSide + row % kSide * kSide;
    }
    [[nodiscard]] static std::size_t column_offset(int x) {
        const auto column = static_cast<std::size_t>(x);
        return column / kSide * kSide * kSide + column % kSide;
    }
    [[nodiscard]] Sample operator[](std::size_t place) const {
        const std::uint32_t bits = samples_[place];
        return {std::bit_cast<float>(bits & ~(kSeenBit | kTornBit)),
                (bits & kSeenBit) != 0 ? DepthKind::kSeen : DepthKind::kFilled,
                (bits & kTornBit) != 0};
    }
    /// The square of kFine samples, by its column and row among these.
    [[nodiscard]] const Range& fine(int column, int row) const {
        return fine_[static_cast<std::size_t>(row) * fine_columns_ +
                     static_cast<std::size_t>(column)];
    }
    [[nodiscard]] const Range& coarse(int column, int row) const {
        return coarse_[static_cast<std::size_t>(row) * coarse_columns_ +
                       static_cast<std::size_t>(column)];
    }

 private:
    static constexpr std::size_t kSide = kFine;
    /// The last bits of a sample's float tell the rest.
    static constexpr std::uint32_t kSeenBit = 1;
    static constexpr std::uint32_t kTornBit = 2;

    int width_ = 0;
    int height_ = 0;
    float nearest_ = 0.0F;
    float farthest_ = 0.0F;
    std::size_t fine_columns_ = 0;
    std::size_t coarse_columns_ = 0;
    std::vector<std::uint32_t> samples_;  ///< Fine square by fine square: each a line of a cache.
    std::vector<Range> fine_;
    std::vector<Range> coarse_;
};

}  // namespace lumi
