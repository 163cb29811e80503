#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// A surface in two photographs.
struct SharedColor {
    Rgb8 own;
    Rgb8 other;
};

/// Of the channel that differs most, in 8-bit levels.
[[nodiscard]] inline int largest_difference(const Rgb8& a, const Rgb8& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// How the colours of another photograph are turned into those of a view's, and by how much those
/// of one surface differ then.
struct ColorMatch {
    std::array<std::array<std::uint8_t, 256>, 3> own_from_other{};
    int tolerance = 0;  ///< 8-bit levels, of the channel that differs most.

    /// The colour of a surface in the other photograph, as it would be in the view's own.
    [[nodiscard]] Rgb8 in_own_colors(const Rgb8& other) const;

    /// Whether both colours may be those of one surface.
    [[nodiscard]] bool is_same(const Rgb8& own, const Rgb8& other) const;
};

/// A gain for each channel, for the exposures of photographs differ, and a tolerance that nine of
/// ten of the surfaces keep, for so do their noise and gloss. Empty where they are fewer than 50.
[[nodiscard]] std::optional<ColorMatch> color_match(const std::vector<SharedColor>& shared);

/// Means of 3 x 3 pixels: noise and the texture of single pixels tell a surface from itself.
[[nodiscard]] ColorImage averaged(const ColorImage& picture);

}  // namespace lumi
