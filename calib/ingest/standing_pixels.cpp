#include "calib/ingest/standing_pixels.h"

#include <algorithm>
#include <cmath>

#include "calib/capture/gray.h"

namespace lumi {

void StandingPixels::Slopes::add(int right, int down) {
    constexpr int kTwiceSlope = 4;  // What noise seldom reaches in all photographs.
    sum_right_ += right;
    sum_down_ += down;
    if (right >= kTwiceSlope) ++counts_[0];
    if (right <= -kTwiceSlope) ++counts_[1];
    if (down >= kTwiceSlope) ++counts_[2];
    if (down <= -kTwiceSlope) ++counts_[3];
}

SharedEdge StandingPixels::Slopes::edge(int photographs) const {
    const auto most = *std::max_element(counts_.begin(), counts_.end());
    return {static_cast<double>(most) / photographs,
            0.5 * std::hypot(sum_right_, sum_down_) / photographs};
}

StandingPixels::StandingPixels(int width_px, int height_px) : sums_(width_px, height_px) {}

void StandingPixels::add(const ColorImage& photograph) {
    const GrayImage gray = gray_of(photograph);
    ++photographs_;
    for (int y = 0; y < gray.height(); ++y) {
        const int above = std::max(0, y - 1);
        const int below = std::min(gray.height() - 1, y + 1);
        for (int x = 0; x < gray.width(); ++x) {
            const int left = std::max(0, x - 1);
            const int right = std::min(gray.width() - 1, x + 1);
            const auto add_slopes = [&](Slopes& slopes, const auto& level) {
                slopes.add(level(right, y) - level(left, y), level(x, below) - level(x, above));
            };
            const std::uint32_t luma = gray(x, y);
            Sums& sums = sums_(x, y);
            sums.luma += luma;
            sums.luma_squared += luma * luma;
            add_slopes(sums.luma_slopes, gray);
            add_slopes(sums.red_slopes, [&](int u, int v) { return photograph(u, v).r; });
            add_slopes(sums.blue_slopes, [&](int u, int v) { return photograph(u, v).b; });
        }
    }
}

double StandingPixels::mean(int x, int y) const { return 1.0 * sums_(x, y).luma / photographs_; }

double StandingPixels::spread(int x, int y) const {
    const double square = 1.0 * sums_(x, y).luma_squared / photographs_;
    const double of_mean = mean(x, y) * mean(x, y);
    return std::sqrt(std::max(0.0, square - of_mean));
}

SharedEdge StandingPixels::edge(int x, int y) const {
    return sums_(x, y).luma_slopes.edge(photographs_);
}

SharedEdge StandingPixels::edge_in_any_color(int x, int y) const {
    const Sums& sums = sums_(x, y);
    return std::max({sums.luma_slopes.edge(photographs_), sums.red_slopes.edge(photographs_),
                     sums.blue_slopes.edge(photographs_)});
}

}  // namespace lumi
