#include "render/subdivision/edge_error.h"

#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

bool is_guess(const BlendVertex& vertex) { return vertex.confidence < kSeenByOne; }

}  // namespace

double edge_error_px(const BlendVertex& a, const BlendVertex& b, const BlendVertex& middle,
                     const EdgeErrorCounts& counts) {
    // At the middle of the picture of an edge, its ends count by one over their depths.
    const float share_a = b.depth / (a.depth + b.depth);
    const float share_b = 1 - share_a;
    float error_px = 0;
    float weight_error = std::abs(middle.opacity - (share_a * a.opacity + share_b * b.opacity));
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<float, 2> off{};
        for (std::size_t axis = 0; axis < 2; ++axis)
            off[axis] = middle.view_pixels[k][axis] -
                        (share_a * a.view_pixels[k][axis] + share_b * b.view_pixels[k][axis]);
        error_px += middle.weights[k] * std::sqrt(off[0] * off[0] + off[1] * off[1]);
        weight_error = std::max(
            weight_error,
            std::abs(middle.weights[k] - (share_a * a.weights[k] + share_b * b.weights[k])));
    }
    const auto seen = [](const BlendVertex& vertex) { return vertex.confidence > 0 ? 1.0F : 0.0F; };
    // Where the photographs do not see the scene, they are looked up at a guess, and others may
    // take their place.
    error_px =
        std::max(error_px, kStepError_px * std::abs(seen(middle) - 0.5F * (seen(a) + seen(b))));
    const double error = std::max(static_cast<double>(error_px),
                                  2 * counts.weight_error_px * static_cast<double>(weight_error));
    return is_guess(middle) ? error / counts.guess_ratio : error;
}

double edge_looseness(const BlendVertex& a, const BlendVertex& b, const BlendVertex& middle,
                      const EdgeErrorCounts& counts) {
    return is_guess(a) && is_guess(middle) && is_guess(b) ? counts.guess_ratio : 1.0;
}

double greatest_relaxation(double error, double length) {
    constexpr double kLargeError = 64.0;
    constexpr double kLeastShare = 0.25;
    // The power below is at least this much: most edges are done without it.
    if (length >= 1 && error * error <= length) return error;
    const double share = std::clamp(std::cbrt(error / kLargeError), kLeastShare, 1.0);
    return std::min(error, std::pow(length, 2 * share));
}

}  // namespace lumi
