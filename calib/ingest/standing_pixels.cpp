#include "calib/ingest/standing_pixels.h"

#include <algorithm>
#include <cmath>

#include "calib/capture/gray.h"

namespace lumi {

StandingPixels::StandingPixels(int width_px, int height_px) : sums_(width_px, height_px) {}

void StandingPixels::add(const ColorImage& photograph) {
    constexpr float kSlope = 2.0F;  // What noise seldom reaches in all photographs.
    const GrayImage gray = gray_of(photograph);
    ++photographs_;
    for (int y = 0; y < gray.height(); ++y) {
        const std::uint8_t* row = gray.row(y);
        const std::uint8_t* above = gray.row(std::max(0, y - 1));
        const std::uint8_t* below = gray.row(std::min(gray.height() - 1, y + 1));
        for (int x = 0; x < gray.width(); ++x) {
            const auto luma = static_cast<float>(row[x]);
            const int left = row[std::max(0, x - 1)];
            const int right = row[std::min(gray.width() - 1, x + 1)];
            const float gradient_x = 0.5F * static_cast<float>(right - left);
            const float gradient_y = 0.5F * static_cast<float>(below[x] - above[x]);
            Sums& sums = sums_(x, y);
            sums.luma += luma;
            sums.luma_squared += luma * luma;
            sums.gradient_x += gradient_x;
            sums.gradient_y += gradient_y;
            if (gradient_x >= kSlope) ++sums.slopes[0];
            if (gradient_x <= -kSlope) ++sums.slopes[1];
            if (gradient_y >= kSlope) ++sums.slopes[2];
            if (gradient_y <= -kSlope) ++sums.slopes[3];
        }
    }
}

double StandingPixels::spread(int x, int y) const {
    const Sums& sums = sums_(x, y);
    const double mean = static_cast<double>(sums.luma) / photographs_;
    const double square = static_cast<double>(sums.luma_squared) / photographs_;
    return std::sqrt(std::max(0.0, square - mean * mean));
}

double StandingPixels::mean_gradient(int x, int y) const {
    const Sums& sums = sums_(x, y);
    return static_cast<double>(std::hypot(sums.gradient_x, sums.gradient_y)) / photographs_;
}

double StandingPixels::same_slope_share(int x, int y) const {
    const auto& slopes = sums_(x, y).slopes;
    return static_cast<double>(*std::max_element(slopes.begin(), slopes.end())) / photographs_;
}

}  // namespace lumi
