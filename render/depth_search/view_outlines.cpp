#include "render/depth_search/view_outlines.h"

#include <algorithm>
#include <array>

namespace lumi {
namespace {

/// Squares along a side of those that share a point.
constexpr int kSharing = 2;

/// A sample of a depth map before one that is farther off.
struct Step {
    int x = 0;
    int y = 0;
    float size = 0.0F;  ///< Of inverse depth; 0: there is none.
};

/// From the nearest to the farthest of a square's four samples; none where the nearest is a guess.
Step step_in_square(const DepthMap& depth, int left, int top) {
    constexpr std::array<std::array<int, 2>, 4> kCorners{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};
    const auto inverse_depth_at = [&](const std::array<int, 2>& corner) {
        return depth.inverse_depth(left + corner[0], top + corner[1]);
    };
    const auto [farthest, nearest] = std::minmax_element(
        kCorners.begin(), kCorners.end(),
        [&](const auto& a, const auto& b) { return inverse_depth_at(a) < inverse_depth_at(b); });
    const int x = left + (*nearest)[0];
    const int y = top + (*nearest)[1];
    if (depth.confidence(x, y) == 0) return {};
    return {x, y, inverse_depth_at(*nearest) - inverse_depth_at(*farthest)};
}

/// Of the torn squares among those that share a point.
Step largest_step(const DepthMap& depth, const GrayImage& torn, int left, int top) {
    Step largest;
    for (int y = top; y < std::min(top + kSharing, torn.height() - 1); ++y) {
        for (int x = left; x < std::min(left + kSharing, torn.width() - 1); ++x) {
            if (torn(x, y) == 0) continue;
            const Step step = step_in_square(depth, x, y);
            if (step.size > largest.size) largest = step;
        }
    }
    return largest;
}

}  // namespace

std::vector<OutlinePoint> view_outlines(const LumigraphView& view, const GrayImage& torn) {
    const DepthMap& depth = view.depth;
    const float pitch_x_px =
        static_cast<float>(view.camera.width_px) / static_cast<float>(torn.width());
    const float pitch_y_px =
        static_cast<float>(view.camera.height_px) / static_cast<float>(torn.height());
    std::vector<OutlinePoint> points;
    for (int top = 0; top < torn.height() - 1; top += kSharing) {
        for (int left = 0; left < torn.width() - 1; left += kSharing) {
            const Step step = largest_step(depth, torn, left, top);
            if (step.size <= 0) continue;
            points.push_back({pitch_x_px * (static_cast<float>(step.x) + 0.5F),
                              pitch_y_px * (static_cast<float>(step.y) + 0.5F),
                              depth.inverse_depth(step.x, step.y), step.size});
        }
    }
    return points;
}

}  // namespace lumi
