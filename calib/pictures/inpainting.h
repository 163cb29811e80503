#pragma once

#include "calib/capture/image.h"

namespace lumi {

/// Paints a picture where the mask, of its size, is 0: from the rim inward, along what lies there
/// (Telea 2004, by OpenCV). Other pixels stay as they are.
void paint_from_rim(const GrayImage& mask, ColorImage& picture);

}  // namespace lumi
