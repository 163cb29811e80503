#include "pipeline/depth_bench/right_shares.h"

#include <algorithm>
#include <cmath>

#include "calib/capture/gray.h"
#include "calib/capture/inverse_depth_warp.h"
#include "calib/work/median.h"
#include "meshing/matching/window_match.h"

namespace lumi {
namespace {

/// True when some neighbour of the view sees the surface that is at this pixel in truth.
bool is_seen(const DepthScene& scene, const std::vector<DepthMap>& truth, std::size_t view_index,
             int x, int y) {
    constexpr double kMaxApartPx = 1.0;
    const DepthView& view = scene.views[view_index];
    const auto inverse_depth = static_cast<double>(truth[view_index].inverse_depth(x, y));
    return std::any_of(view.neighbours.begin(), view.neighbours.end(), [&](int j) {
        const DepthView& other = scene.views[static_cast<std::size_t>(j)];
        const DepthMap& map = truth[static_cast<std::size_t>(j)];
        const auto there = warp_from(view).to(other).at({x + 0.5, y + 0.5}, inverse_depth);
        if (!there) return false;
        const int column = static_cast<int>(std::floor(there->pixel.x()));
        const int row = static_cast<int>(std::floor(there->pixel.y()));
        if (!map.confidence.contains(column, row)) return false;
        const double before =
            static_cast<double>(map.inverse_depth(column, row)) - there->inverse_depth;
        return before * other.disparity_px_per_inverse_depth <= kMaxApartPx;
    });
}

/// Counts pixels, and those within one pixel of the true disparity.
struct RightCount {
    std::size_t all = 0;
    std::size_t right = 0;

    void add(bool is_right) {
        ++all;
        if (is_right) ++right;
    }
    [[nodiscard]] double share() const {
        return all == 0 ? 0.0 : static_cast<double>(right) / static_cast<double>(all);
    }
};

}  // namespace

RightShares right_shares(const DepthScene& scene, const std::vector<DepthMap>& truth,
                         const std::vector<DepthMap>& found) {
    RightCount confident;
    RightCount visible;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const DepthView& view = scene.views[i];
        const GrayImage gray = gray_of(view.photograph);
        for (int y = 0; y < gray.height(); ++y) {
            for (int x = 0; x < gray.width(); ++x) {
                if (truth[i].confidence(x, y) == 0) continue;
                const double error = static_cast<double>(
                    std::abs(truth[i].inverse_depth(x, y) - found[i].inverse_depth(x, y)));
                const bool is_right = error * view.disparity_px_per_inverse_depth <= 1;
                if (found[i].confidence(x, y) != 0) confident.add(is_right);
                if (!reference_window(gray, x, y).has_texture) continue;
                if (is_seen(scene, truth, i, x, y)) visible.add(is_right);
            }
        }
    }
    return {confident.share(), visible.share()};
}

std::optional<double> points_by_truth(const DepthScene& scene, const std::vector<DepthMap>& truth) {
    constexpr std::size_t kLeastPoints = 20;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
        for (const SparsePoint& point : scene.views[i].points) {
            const Eigen::Vector2i pixel = point.pixel.array().floor().cast<int>();
            if (!truth[i].confidence.contains(pixel.x(), pixel.y())) continue;
            const auto there = static_cast<double>(truth[i].inverse_depth(pixel.x(), pixel.y()));
            if (truth[i].confidence(pixel.x(), pixel.y()) == 0 || there <= 0) continue;
            ratios.push_back(point.inverse_depth / there);
        }
    }
    if (ratios.size() < kLeastPoints) return std::nullopt;
    return median_of(std::move(ratios));
}

}  // namespace lumi
