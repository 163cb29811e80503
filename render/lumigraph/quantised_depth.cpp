#include "render/lumigraph/quantised_depth.h"

#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

constexpr double kSteps = 65535.0;

}  // namespace

QuantisedDepth quantise(const FloatImage& inverse_depth) {
    QuantisedDepth result;
    result.steps = Image<std::uint16_t>(inverse_depth.width(), inverse_depth.height());
    const auto [low, high] =
        std::minmax_element(inverse_depth.pixels().begin(), inverse_depth.pixels().end());
    result.min_inverse_depth = static_cast<double>(*low);
    result.max_inverse_depth = static_cast<double>(*high);
    const double range = result.max_inverse_depth - result.min_inverse_depth;
    if (!(range > 0)) return result;
    for (std::size_t i = 0; i < result.steps.pixels().size(); ++i) {
        const double above =
            static_cast<double>(inverse_depth.pixels()[i]) - result.min_inverse_depth;
        result.steps.pixels()[i] = static_cast<std::uint16_t>(std::lround(above / range * kSteps));
    }
    return result;
}

FloatImage dequantise(const QuantisedDepth& quantised) {
    FloatImage inverse_depth(quantised.steps.width(), quantised.steps.height());
    for (std::size_t i = 0; i < inverse_depth.pixels().size(); ++i) {
        inverse_depth.pixels()[i] =
            static_cast<float>(std::lerp(quantised.min_inverse_depth, quantised.max_inverse_depth,
                                         quantised.steps.pixels()[i] / kSteps));
    }
    return inverse_depth;
}

}  // namespace lumi
