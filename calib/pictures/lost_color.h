#pragma once

#include "calib/capture/image.h"

namespace lumi {

/// Whether a picture shows any color: its channels are more than 3 levels apart in more than 0.5 %
/// of its pixels. Conversion and compression of black and white stay below the one, and a date that
/// is stamped on it below the other.
[[nodiscard]] bool has_color(const ColorImage& picture);

/// The same in black and white, as JPEG takes it: luma of Rec. 601 in all three channels.
[[nodiscard]] ColorImage without_color(const ColorImage& picture);

}  // namespace lumi
