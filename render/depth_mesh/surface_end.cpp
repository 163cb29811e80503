#include "render/depth_mesh/surface_end.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace lumi {
namespace {

/// From the last sample to halfway to the next.
float along_slope(std::span<const float> last_samples) {
    return last_samples.size() < 2 ? 0.0F : 0.5F * (last_samples[0] - last_samples[1]);
}

/// From the last sample to the vertex of the parabola a * t + b * t * t of places, where t is
/// inverse depth less that of the last sample: -1 at the one before, -2 at the one before that.
/// None where inverse depth does not fall faster and faster, or where the vertex is not before the
/// next sample.
std::optional<float> to_outline(std::span<const float> last_samples) {
    if (last_samples.size() < kEndSamples) return std::nullopt;
    const float one_back = last_samples[1] - last_samples[0];
    const float two_back = last_samples[2] - last_samples[0];
    if (one_back <= 0 || two_back <= one_back || two_back >= 2 * one_back) return std::nullopt;
    const float scale = one_back * two_back * (two_back - one_back);
    const float a = (2 * one_back * one_back - two_back * two_back) / scale;
    const float b = (two_back - 2 * one_back) / scale;
    const float vertex = -a / (2 * b);
    const float place = 0.5F * a * vertex;
    if (vertex >= 0 || place >= 1) return std::nullopt;
    return vertex;
}

}  // namespace

float inverse_depth_at_end(std::span<const float> last_samples, float beyond) {
    assert(!last_samples.empty());
    const float last = last_samples[0];
    float step = along_slope(last_samples);
    if (last > beyond) step = to_outline(last_samples).value_or(step);
    const float most = 0.5F * std::abs(beyond - last);
    return std::max(0.0F, last + std::clamp(step, -most, most));
}

}  // namespace lumi
