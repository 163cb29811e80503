#pragma once

#include "calib/capture/image.h"

namespace lumi {

/// A colour for a share of the whole, 0 to 1 (clamped): dark blue over grey to bright yellow.
/// Lightness rises evenly and the hues stay apart for colour-blind eyes (the cividis map of Nunez,
/// Anderton and Renslow, 2018, sampled at nine places).
[[nodiscard]] Rgb8 color_of_share(float share);

}  // namespace lumi
