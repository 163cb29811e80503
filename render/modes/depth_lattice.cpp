#include "render/modes/depth_lattice.h"

#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

/// A step that misses the continuation of both sides by more than this, in pixels of disparity for
/// each pixel of pitch, is a tear: drawn as a surface it would be stretched to twice its width.
constexpr double kMaxBend = 1.0;
/// A steeper slope than this is a smeared edge, not a surface: its other side cannot be seen by the
/// neighbouring view (the disparity gradient limit, Burt and Julesz 1980, is 1).
constexpr double kMaxSlope = 2.0;

}  // namespace

DepthLattice::DepthLattice(const DepthMap& depth, const Camera& camera, double disparity_px)
    : columns_(depth.inverse_depth.width() + 2),
      rows_(depth.inverse_depth.height() + 2),
      pitch_x_px_(static_cast<double>(camera.width_px) / depth.inverse_depth.width()),
      pitch_y_px_(static_cast<double>(camera.height_px) / depth.inverse_depth.height()),
      disparity_px_(disparity_px),
      inverse_depth_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)),
      seen_(inverse_depth_.size()) {
    for (int y = 0; y < depth.inverse_depth.height(); ++y) {
        for (int x = 0; x < depth.inverse_depth.width(); ++x) {
            inverse_depth_[index(x + 1, y + 1)] = depth.inverse_depth(x, y);
            seen_[index(x + 1, y + 1)] = depth.confidence(x, y) > 0 ? 1 : 0;
        }
    }
    fill_ring();
}

/// Border nodes lie half a pitch beyond the outermost samples: half a step of the slope further.
void DepthLattice::fill_ring() {
    const auto continue_from = [&](int column, int row, int step_x, int step_y, double pitch_px) {
        const std::size_t edge = index(column + step_x, row + step_y);
        const std::size_t inner = contains(column + 3 * step_x, row + 3 * step_y)
                                      ? index(column + 2 * step_x, row + 2 * step_y)
                                      : edge;
        const float slope = inverse_depth_[edge] - inverse_depth_[inner];
        const bool is_slope =
            std::abs(static_cast<double>(slope)) * disparity_px_ < kMaxBend * pitch_px &&
            seen_[edge] == seen_[inner];
        inverse_depth_[index(column, row)] =
            std::max(0.0F, inverse_depth_[edge] + (is_slope ? 0.5F * slope : 0.0F));
        seen_[index(column, row)] = seen_[edge];
    };
    for (int row = 1; row + 1 < rows_; ++row) {
        continue_from(0, row, 1, 0, pitch_x_px_);
        continue_from(columns_ - 1, row, -1, 0, pitch_x_px_);
    }
    for (int column = 0; column < columns_; ++column) {
        continue_from(column, 0, 0, 1, pitch_y_px_);
        continue_from(column, rows_ - 1, 0, -1, pitch_y_px_);
    }
}

Eigen::Vector2f DepthLattice::position_px(int column, int row) const {
    const double x = std::clamp(column - 0.5, 0.0, static_cast<double>(columns_ - 2));
    const double y = std::clamp(row - 0.5, 0.0, static_cast<double>(rows_ - 2));
    return {static_cast<float>(x * pitch_x_px_), static_cast<float>(y * pitch_y_px_)};
}

bool DepthLattice::tears_right(int column, int row) const {
    return tears(column, row, 1, 0, pitch_x_px_);
}

bool DepthLattice::tears_below(int column, int row) const {
    return tears(column, row, 0, 1, pitch_y_px_);
}

bool DepthLattice::tears(int column, int row, int step_x, int step_y, double pitch_px) const {
    const double here = inverse_depth(column, row);
    const double there = inverse_depth(column + step_x, row + step_y);
    const double step = std::abs(there - here);
    const auto bend_at = [&](int beyond_column, int beyond_row, double near, double far) {
        if (!contains(beyond_column, beyond_row)) return step;
        const double beyond = inverse_depth(beyond_column, beyond_row);
        return std::abs(far - (2 * near - beyond));
    };
    const double bend = std::min(bend_at(column - step_x, row - step_y, here, there),
                                 bend_at(column + 2 * step_x, row + 2 * step_y, there, here));
    return bend * disparity_px_ > kMaxBend * pitch_px ||
           step * disparity_px_ > kMaxSlope * pitch_px;
}

}  // namespace lumi
