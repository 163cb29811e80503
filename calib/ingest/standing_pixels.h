#pragma once

#include <array>
#include <cstdint>

#include "calib/capture/image.h"

namespace lumi {

/// How each pixel of photographs of one size changes from one to the next, told without keeping
/// them: in 8-bit levels of luma.
class StandingPixels {
 public:
    StandingPixels(int width_px, int height_px);

    void add(const ColorImage& photograph);

    [[nodiscard]] int photographs() const { return photographs_; }
    [[nodiscard]] int width() const { return sums_.width(); }
    [[nodiscard]] int height() const { return sums_.height(); }

    /// Standard deviation over the photographs.
    [[nodiscard]] double spread(int x, int y) const;

    /// Length of the mean gradient, a pixel.
    [[nodiscard]] double mean_gradient(int x, int y) const;
    /// Share of the photographs that become brighter (or all darker) here in one and the same of
    /// the directions right and down: 1 on an edge that stands still.
    [[nodiscard]] double same_slope_share(int x, int y) const;

 private:
    struct Sums {
        float luma = 0;
        float luma_squared = 0;
        float gradient_x = 0;
        float gradient_y = 0;
        /// How many photographs rise to the right, fall, rise downwards, fall.
        std::array<std::uint16_t, 4> slopes{};
    };
    Image<Sums> sums_;
    int photographs_ = 0;
};

}  // namespace lumi
