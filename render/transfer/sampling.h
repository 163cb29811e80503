#pragma once

#include <Eigen/Core>

#include "calib/capture/bilinear.h"
#include "calib/capture/image.h"

namespace lumi {

/// Bilinear interpolation (bilinear.h) of what is 0 beyond the image: it goes to 0 within a pixel
/// from the outermost centres.
[[nodiscard]] double bilinear_to_zero(const GrayImage& image, const Eigen::Vector2d& pixel);

/// The sample whose square the pixel lies in, or the nearest of the border.
[[nodiscard]] double nearest(const FloatImage& image, const Eigen::Vector2d& pixel);

}  // namespace lumi
