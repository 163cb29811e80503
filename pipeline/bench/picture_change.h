#pragma once

#include "calib/capture/image.h"

namespace lumi {

/// Mean |a - a_before| over pixels and channels, in steps of 1/255.
[[nodiscard]] double change(const ColorImage& a, const ColorImage& a_before);

/// How unlike one change is to another: mean |(a - a_before) - (b - b_before)| over pixels and
/// channels, in steps of 1/255; with the truth as b, the flicker of a.
[[nodiscard]] double unlike_change(const ColorImage& a, const ColorImage& a_before,
                                   const ColorImage& b, const ColorImage& b_before);

}  // namespace lumi
