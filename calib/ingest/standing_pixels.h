#pragma once

#include <array>
#include <compare>
#include <cstdint>

#include "calib/capture/image.h"

namespace lumi {

/// What compression leaves of one colour, in 8-bit levels of luma: no larger spread stands still.
inline constexpr double kStillSpread = 4.0;

/// An edge as photographs share it.
struct SharedEdge {
    /// Largest share of the photographs that become brighter by 2 levels a pixel and more towards
    /// the right, or all darker, or brighter downwards, or darker: 1 where it stands still.
    double same_slope_share = 0;
    double mean_gradient = 0;  ///< Length of the mean gradient, in levels a pixel.

    auto operator<=>(const SharedEdge&) const = default;
};

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

    [[nodiscard]] SharedEdge edge(int x, int y) const;
    /// The same of luma, red or blue, whichever most photographs agree on (of equals that with the
    /// longest mean gradient): coloured print may have the luma of what it lies on.
    [[nodiscard]] SharedEdge edge_in_any_color(int x, int y) const;

 private:
    class Slopes {
     public:
        /// Differences over two pixels.
        void add(int right, int down);
        [[nodiscard]] SharedEdge edge(int photographs) const;

     private:
        std::int32_t sum_right_ = 0;
        std::int32_t sum_down_ = 0;
        /// How many photographs rise to the right, fall, rise downwards, fall.
        std::array<std::uint16_t, 4> counts_{};
    };
    struct Sums {
        std::uint32_t luma = 0;
        std::uint32_t luma_squared = 0;
        Slopes luma_slopes;
        Slopes red_slopes;
        Slopes blue_slopes;
    };
    Image<Sums> sums_;
    int photographs_ = 0;
};

}  // namespace lumi
