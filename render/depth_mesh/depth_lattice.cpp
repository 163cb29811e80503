#include "render/depth_mesh/depth_lattice.h"

#include <algorithm>
#include <cmath>

#include "render/depth_mesh/small_regions.h"

namespace lumi {
namespace {

/// Regions of at most so many samples, seen or filled, are specks.
constexpr std::size_t kSpeck = 16;

std::vector<std::uint8_t> seen_samples(const GrayImage& confidence) {
    std::vector<std::uint8_t> seen;
    for (const std::uint8_t value : confidence.pixels()) seen.push_back(value > 0 ? 1 : 0);
    absorb_small_regions(seen, confidence.width(), kSpeck);
    return seen;
}

}  // namespace

DepthLattice::DepthLattice(const DepthMap& depth, const Camera& camera, double disparity_px)
    : columns_(depth.inverse_depth.width() + 2),
      rows_(depth.inverse_depth.height() + 2),
      pitch_x_px_(static_cast<double>(camera.width_px) / depth.inverse_depth.width()),
      pitch_y_px_(static_cast<double>(camera.height_px) / depth.inverse_depth.height()),
      disparity_px_(disparity_px),
      disparity_per_pitch_(disparity_per_pitch(depth, camera, disparity_px)),
      inverse_depth_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)),
      seen_(inverse_depth_.size()) {
    const std::vector<std::uint8_t> seen = seen_samples(depth.confidence);
    for (int y = 0; y < depth.inverse_depth.height(); ++y) {
        for (int x = 0; x < depth.inverse_depth.width(); ++x) {
            inverse_depth_[index(x + 1, y + 1)] = depth.inverse_depth(x, y);
            seen_[index(x + 1, y + 1)] = seen[static_cast<std::size_t>(y * (columns_ - 2) + x)];
        }
    }
    fill_ring();
}

/// Border nodes lie half a pitch beyond the outermost samples: half a step of the slope further.
void DepthLattice::fill_ring() {
    const auto continue_from = [&](int column, int row, int step_x, int step_y,
                                   double disparity_per_pitch) {
        const std::size_t edge = index(column + step_x, row + step_y);
        const std::size_t inner = contains(column + 3 * step_x, row + 3 * step_y)
                                      ? index(column + 2 * step_x, row + 2 * step_y)
                                      : edge;
        const float slope = inverse_depth_[edge] - inverse_depth_[inner];
        const bool is_slope =
            std::abs(static_cast<double>(slope)) <= gentle_step(disparity_per_pitch) &&
            seen_[edge] == seen_[inner];
        inverse_depth_[index(column, row)] =
            std::max(0.0F, inverse_depth_[edge] + (is_slope ? 0.5F * slope : 0.0F));
        seen_[index(column, row)] = seen_[edge];
    };
    for (int row = 1; row + 1 < rows_; ++row) {
        continue_from(0, row, 1, 0, disparity_per_pitch_.along_row);
        continue_from(columns_ - 1, row, -1, 0, disparity_per_pitch_.along_row);
    }
    for (int column = 0; column < columns_; ++column) {
        continue_from(column, 0, 0, 1, disparity_per_pitch_.along_column);
        continue_from(column, rows_ - 1, 0, -1, disparity_per_pitch_.along_column);
    }
}

float DepthLattice::continued_inverse_depth(int column, int row) const {
    const int ring_column = std::min(column, columns_ - 1);
    const int ring_row = std::min(row, rows_ - 1);
    const float at_ring = inverse_depth(ring_column, ring_row);
    if (contains(column, row)) return at_ring;
    const float inside =
        inverse_depth(std::max(0, 2 * ring_column - column), std::max(0, 2 * ring_row - row));
    return std::max(0.0F, 2 * at_ring - inside);
}

Eigen::Vector2f DepthLattice::position_px(int column, int row) const {
    // The ring is half a pitch from its neighbours on both sides.
    const auto pitches = [](int at, int count) {
        if (at == 0) return 0.0;
        if (at < count - 1) return at - 0.5;
        return at == count - 1 ? at - 1.0 : at - 1.5;
    };
    return {static_cast<float>(pitches(column, columns_) * pitch_x_px_),
            static_cast<float>(pitches(row, rows_) * pitch_y_px_)};
}

bool DepthLattice::tears_right(int column, int row) const {
    return tears_along(column, row, 1, 0, disparity_per_pitch_.along_row);
}

bool DepthLattice::tears_below(int column, int row) const {
    return tears_along(column, row, 0, 1, disparity_per_pitch_.along_column);
}

bool DepthLattice::tears_along(int column, int row, int step_x, int step_y,
                               double disparity_per_pitch) const {
    const float here = inverse_depth(column, row);
    const float there = inverse_depth(column + step_x, row + step_y);
    const auto beyond = [&](int steps, float end) {
        const int at_column = column + steps * step_x;
        const int at_row = row + steps * step_y;
        return contains(at_column, at_row) ? inverse_depth(at_column, at_row) : end;
    };
    return tears({beyond(-1, here), here, there, beyond(2, there)}, disparity_per_pitch);
}

}  // namespace lumi
