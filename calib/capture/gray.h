#pragma once

#include "calib/capture/image.h"

namespace lumi {

/// Rec. 709 luma of an sRGB picture, rounded.
[[nodiscard]] GrayImage gray_of(const ColorImage& image);

}  // namespace lumi
