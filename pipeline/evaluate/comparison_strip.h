#pragma once

#include "calib/capture/image.h"

namespace lumi {

/// Photograph | rendering | error, side by side. The error is the largest difference of the three
/// channels, from dark blue (0) to bright yellow (`full_scale` of 255 and more), with the scale as
/// a bar below it; pixels that were not drawn are hatched.
[[nodiscard]] ColorImage comparison_strip(const ColorImage& photograph, const ColorImage& rendering,
                                          const GrayImage& coverage, int full_scale = 64);

/// The three pictures of a strip.
struct ComparisonPanels {
    ColorImage photograph;
    ColorImage rendering;
    ColorImage error;
};

/// Takes a strip apart again. Throws Error (E-EVAL-SIZE) when the picture is none.
[[nodiscard]] ComparisonPanels panels_of(const ColorImage& strip);

}  // namespace lumi
