#pragma once

#include "calib/capture/image.h"

namespace lumi {

/// Variance of the Laplacian of the brightness: larger is sharper, comparable between frames of one
/// scene only (Pech-Pacheco et al., Diatom autofocusing in brightfield microscopy, 2000).
[[nodiscard]] double sharpness(const GrayImage& brightness);

}  // namespace lumi
