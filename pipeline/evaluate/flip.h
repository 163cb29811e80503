#pragma once

#include <numbers>
#include <optional>

#include "calib/capture/image.h"

namespace lumi {

/// Pixels in a degree of visual angle: a monitor of 3840 pixels and 0.7 m width seen from 0.7 m, as
/// in the program that the authors published.
constexpr double kFlipPixelsPerDegree = 0.7 * 3840 / 0.7 * std::numbers::pi / 180.0;

/// LDR-FLIP: at each pixel how different two pictures look when one flips between them, 0 (equal)
/// to 1 (Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", HPG 2020, with
/// the filter normalisation and error redistribution of that paper's sections 4 and 5). Throws
/// Error (E-EVAL-SIZE) when sizes differ.
[[nodiscard]] FloatImage flip_error_map(const ColorImage& reference, const ColorImage& test,
                                        double pixels_per_degree = kFlipPixelsPerDegree);

/// Mean of an error map over all pixels.
[[nodiscard]] double mean_error(const FloatImage& error_map);

/// Mean over the pixels where `coverage` is not 0; empty when there is none. Throws Error
/// (E-EVAL-SIZE) when sizes differ.
[[nodiscard]] std::optional<double> mean_error(const FloatImage& error_map,
                                               const GrayImage& coverage);

}  // namespace lumi
