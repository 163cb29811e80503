#include "render/depth_search/tiled_depth.h"

#include <algorithm>
#include <limits>

namespace lumi {
namespace {

constexpr TiledDepth::Range kNothing{std::numeric_limits<float>::max(), 0.0F};

std::size_t squares(int samples, int side) {
    return static_cast<std::size_t>((samples + side - 1) / side);
}

void widen(TiledDepth::Range& range, const TiledDepth::Range& by) {
    range.farthest = std::min(range.farthest, by.farthest);
    range.nearest = std::max(range.nearest, by.nearest);
}

/// With the samples around the fine square, which surfaces within it are interpolated with.
TiledDepth::Range range_of(int left, int top, const FloatImage& values) {
    TiledDepth::Range range = kNothing;
    const int right = std::min(left + TiledDepth::kFine, values.width() - 1);
    const int bottom = std::min(top + TiledDepth::kFine, values.height() - 1);
    for (int y = std::max(0, top - 1); y <= bottom; ++y) {
        const float* row = values.row(y);
        for (int x = std::max(0, left - 1); x <= right; ++x) widen(range, {row[x], row[x]});
    }
    return range;
}

}  // namespace

TiledDepth::TiledDepth(const DepthMap& depth, const GrayImage& torn_squares)
    : width_(depth.inverse_depth.width()),
      height_(depth.inverse_depth.height()),
      fine_columns_(squares(width_, kFine)),
      coarse_columns_(squares(width_, kCoarse)) {
    const std::size_t fine_rows = squares(height_, kFine);
    samples_.resize(fine_columns_ * fine_rows * kFine * kFine);
    fine_.resize(fine_columns_ * fine_rows, kNothing);
    coarse_.resize(coarse_columns_ * squares(height_, kCoarse), kNothing);
    for (int y = 0; y < height_; ++y) {
        const float* values = depth.inverse_depth.row(y);
        const std::uint8_t* confidences = depth.confidence.row(y);
        const std::uint8_t* torn = torn_squares.row(y);
        std::uint32_t* row = samples_.data() + row_offset(y);
        for (int x = 0; x < width_; ++x)
            row[column_offset(x)] =
                (std::bit_cast<std::uint32_t>(values[x]) & ~(kSeenBit | kTornBit)) |
                (confidences[x] > 0 ? kSeenBit : 0) | (torn[x] > 0 ? kTornBit : 0);
    }
    for (std::size_t i = 0; i < fine_.size(); ++i)
        fine_[i] = range_of(static_cast<int>(i % fine_columns_) * kFine,
                            static_cast<int>(i / fine_columns_) * kFine, depth.inverse_depth);
    constexpr std::size_t kFinePerCoarse = kCoarse / kFine;
    if (!fine_.empty()) farthest_ = fine_.front().farthest;
    for (std::size_t i = 0; i < fine_.size(); ++i) {
        const std::size_t column = i % fine_columns_ / kFinePerCoarse;
        const std::size_t row = i / fine_columns_ / kFinePerCoarse;
        widen(coarse_[row * coarse_columns_ + column], fine_[i]);
        nearest_ = std::max(nearest_, fine_[i].nearest);
        farthest_ = std::min(farthest_, fine_[i].farthest);
    }
}

}  // namespace lumi
