#pragma once

#include <array>
#include <cstdint>

#include "calib/capture/image.h"

namespace lumi {

/// What compression leaves of one colour, in 8-bit levels of luma: no larger spread stands still.
inline constexpr double kStillSpread = 4.0;

/// How each pixel of up to 65 000 photographs of one size changes from one to the next, told
/// without keeping them: in 8-bit levels of luma. Nothing can be asked before the first is added.
class StandingPixels {
 public:
    StandingPixels(int width_px, int height_px);

    /// A photograph of that size.
    void add(const ColorImage& photograph);

    [[nodiscard]] int photographs() const { return photographs_; }
    [[nodiscard]] int width() const { return sums_.width(); }
    [[nodiscard]] int height() const { return sums_.height(); }

    /// Mean and standard deviation over the photographs.
    [[nodiscard]] double mean(int x, int y) const;
    [[nodiscard]] double spread(int x, int y) const;

    /// Length of the mean gradient, in levels a pixel.
    [[nodiscard]] double mean_gradient(int x, int y) const;
    /// Largest share of the photographs that become brighter by 2 levels a pixel and more towards
    /// the right, or all darker, or brighter downwards, or darker: 1 on an edge that stands still.
    [[nodiscard]] double same_slope_share(int x, int y) const;

 private:
    struct Sums {
        std::uint32_t luma = 0;
        std::uint32_t luma_squared = 0;
        std::int32_t twice_gradient_x = 0;
        std::int32_t twice_gradient_y = 0;
        /// How many photographs rise to the right, fall, rise downwards, fall.
        std::array<std::uint16_t, 4> slopes{};
    };
    Image<Sums> sums_;
    int photographs_ = 0;
};

}  // namespace lumi
