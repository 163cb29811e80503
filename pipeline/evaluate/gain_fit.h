#pragma once

#include <array>
#include <optional>

#include "calib/capture/image.h"

namespace lumi {

/// photograph = gain * rendering + bias, per channel, by least squares over covered pixels: what
/// exposure and white balance explain of a difference. They drift from photograph to photograph and
/// are no fault of the rendering.
struct GainFit {
    std::array<double, 3> gain{1.0, 1.0, 1.0};
    std::array<double, 3> bias{};  ///< In 8-bit steps.
    double psnr_db = 0.0;          ///< Over covered pixels, after the fit.
};

/// Empty when nothing is covered. A channel that does not vary keeps gain 1. Throws Error
/// (E-EVAL-SIZE) when sizes differ.
[[nodiscard]] std::optional<GainFit> fit_gain(const ColorImage& photograph,
                                              const ColorImage& rendering,
                                              const GrayImage& coverage);

}  // namespace lumi
