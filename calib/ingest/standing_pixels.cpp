#include "calib/ingest/standing_pixels.h"

#include <algorithm>
#include <cmath>

#include "calib/capture/gray.h"

namespace lumi {

StandingPixels::StandingPixels(int width_px, int height_px) : sums_(width_px, height_px) {}

void StandingPixels::add(const ColorImage& photograph) {
    constexpr int kTwiceSlope = 4;  // What noise seldom reaches in all photographs.
    const GrayImage gray = gray_of(photograph);
    ++photographs_;
    for (int y = 0; y < gray.height(); ++y) {
        const std::uint8_t* row = gray.row(y);
        const std::uint8_t* above = gray.row(std::max(0, y - 1));
        const std::uint8_t* below = gray.row(std::min(gray.height() - 1, y + 1));
        for (int x = 0; x < gray.width(); ++x) {
            const std::uint32_t luma = row[x];
            const int right = row[std::min(gray.width() - 1, x + 1)] - row[std::max(0, x - 1)];
            const int down = below[x] - above[x];
            Sums& sums = sums_(x, y);
            sums.luma += luma;
            sums.luma_squared += luma * luma;
            sums.twice_gradient_x += right;
            sums.twice_gradient_y += down;
            if (right >= kTwiceSlope) ++sums.slopes[0];
            if (right <= -kTwiceSlope) ++sums.slopes[1];
            if (down >= kTwiceSlope) ++sums.slopes[2];
            if (down <= -kTwiceSlope) ++sums.slopes[3];
        }
    }
}

double StandingPixels::mean(int x, int y) const { return 1.0 * sums_(x, y).luma / photographs_; }

double StandingPixels::spread(int x, int y) const {
    const double square = 1.0 * sums_(x, y).luma_squared / photographs_;
    const double of_mean = mean(x, y) * mean(x, y);
    return std::sqrt(std::max(0.0, square - of_mean));
}

double StandingPixels::mean_gradient(int x, int y) const {
    const Sums& sums = sums_(x, y);
    return 0.5 * std::hypot(sums.twice_gradient_x, sums.twice_gradient_y) / photographs_;
}

double StandingPixels::same_slope_share(int x, int y) const {
    const auto& slopes = sums_(x, y).slopes;
    return static_cast<double>(*std::max_element(slopes.begin(), slopes.end())) / photographs_;
}

}  // namespace lumi
