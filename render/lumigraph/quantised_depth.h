#pragma once

#include <cstdint>

#include "calib/capture/image.h"

namespace lumi {

/// Inverse depth in 65536 even steps between its smallest and its largest value. Even steps in
/// inverse depth are even steps in pixels of parallax.
struct QuantisedDepth {
    Image<std::uint16_t> steps;
    double min_inverse_depth = 0.0;
    double max_inverse_depth = 0.0;
};

/// The error is at most half a step: (max - min) / 131070.
[[nodiscard]] QuantisedDepth quantise(const FloatImage& inverse_depth);
[[nodiscard]] FloatImage dequantise(const QuantisedDepth& quantised);

}  // namespace lumi
