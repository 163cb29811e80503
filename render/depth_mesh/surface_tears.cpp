#include "render/depth_mesh/surface_tears.h"

#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

/// In pixels of disparity for each pixel of pitch, as the next: drawn as a surface, such a step is
/// stretched over two pixels at most.
constexpr double kGentle = 2.0;
/// A steeper slope than this is a smeared edge, not a surface: its other side cannot be seen by the
/// neighbouring view (the disparity gradient limit, Burt and Julesz 1980, is 1), also when both
/// ends err.
constexpr double kMaxSlope = 4.0;

/// 1 for each sample from which the surface tears to the next one in the row.
GrayImage tears_in_rows(const FloatImage& inverse_depth, double disparity_per_pitch) {
    const int last = inverse_depth.width() - 1;
    GrayImage torn(inverse_depth.width(), inverse_depth.height());
    for (int y = 0; y < inverse_depth.height(); ++y) {
        const float* row = inverse_depth.row(y);
        for (int x = 0; x < last; ++x)
            torn(x, y) =
                tears({row[std::max(0, x - 1)], row[x], row[x + 1], row[std::min(x + 2, last)]},
                      disparity_per_pitch)
                    ? 1
                    : 0;
    }
    return torn;
}

/// The same to the next one in the column.
GrayImage tears_in_columns(const FloatImage& inverse_depth, double disparity_per_pitch) {
    const int last = inverse_depth.height() - 1;
    GrayImage torn(inverse_depth.width(), inverse_depth.height());
    for (int y = 0; y < last; ++y) {
        const float* before = inverse_depth.row(std::max(0, y - 1));
        const float* here = inverse_depth.row(y);
        const float* there = inverse_depth.row(y + 1);
        const float* beyond = inverse_depth.row(std::min(y + 2, last));
        for (int x = 0; x < inverse_depth.width(); ++x)
            torn(x, y) =
                tears({before[x], here[x], there[x], beyond[x]}, disparity_per_pitch) ? 1 : 0;
    }
    return torn;
}

}  // namespace

DisparityPerPitch disparity_per_pitch(const DepthMap& depth, const Camera& camera,
                                      double disparity_px) {
    return {disparity_px * depth.inverse_depth.width() / camera.width_px,
            disparity_px * depth.inverse_depth.height() / camera.height_px};
}

double gentle_step(double disparity_per_pitch) { return kGentle / disparity_per_pitch; }

bool tears(const std::array<float, 4>& inverse_depths, double disparity_per_pitch) {
    const auto [before, here, there, beyond] = inverse_depths;
    const auto is_within = [&](float step, double gradient) {
        return static_cast<double>(std::abs(step)) * disparity_per_pitch <= gradient;
    };
    const float step = there - here;
    if (is_within(step, kGentle)) return false;
    const bool goes_on =
        is_within(step - (here - before), kGentle) || is_within(step - (beyond - there), kGentle);
    return !goes_on || !is_within(step, kMaxSlope);
}

GrayImage torn_squares(const FloatImage& inverse_depth, const DisparityPerPitch& disparity) {
    const GrayImage to_right = tears_in_rows(inverse_depth, disparity.along_row);
    const GrayImage to_below = tears_in_columns(inverse_depth, disparity.along_column);
    GrayImage torn(inverse_depth.width(), inverse_depth.height());
    for (int y = 0; y < torn.height(); ++y) {
        const int below = std::min(y + 1, torn.height() - 1);
        for (int x = 0; x < torn.width(); ++x) {
            const int right = std::min(x + 1, torn.width() - 1);
            const bool is_torn = to_right(x, y) != 0 || to_right(x, below) != 0 ||
                                 to_below(x, y) != 0 || to_below(right, y) != 0;
            torn(x, y) = is_torn ? 1 : 0;
        }
    }
    return torn;
}

}  // namespace lumi
