#include "render/modes/surface_end.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace lumi {
namespace {

/// From a last sample: how many samples on, and by how much inverse depth grows on the way.
struct Step {
    float samples;
    float inverse_depth;
};

Step straight_on(std::span<const float> last_samples, float samples) {
    const float slope = last_samples.size() < 2 ? 0.0F : last_samples[0] - last_samples[1];
    return {samples, samples * slope};
}

/// The vertex of the parabola a * t + b * t * t of places, where t is the inverse depth less that
/// of the last sample: -1 at the one before, -2 at the one before that. None where inverse depth
/// does not fall faster and faster towards it, or where it would not come before the next sample.
std::optional<Step> outline(std::span<const float> last_samples) {
    if (last_samples.size() < kEndSamples) return std::nullopt;
    const float one_back = last_samples[1] - last_samples[0];
    const float two_back = last_samples[2] - last_samples[0];
    if (one_back <= 0 || two_back <= one_back || two_back >= 2 * one_back) return std::nullopt;
    const float scale = one_back * two_back * (two_back - one_back);
    const float a = (2 * one_back * one_back - two_back * two_back) / scale;
    const float b = (two_back - 2 * one_back) / scale;
    const Step step{-a * a / (4 * b), -a / (2 * b)};
    if (step.inverse_depth >= 0 || step.samples >= 1) return std::nullopt;
    return step;
}

}  // namespace

SurfaceEnds surface_ends(std::span<const float> nearer, std::span<const float> farther) {
    assert(!nearer.empty() && !farther.empty());
    const Step to_end = outline(nearer).value_or(straight_on(nearer, 0.5F));
    const Step from_beyond = straight_on(farther, 1 - to_end.samples);
    const float most = 0.5F * (nearer[0] - farther[0]);
    const auto ended = [&](float last, const Step& step) {
        return std::max(0.0F, last + std::clamp(step.inverse_depth, -most, most));
    };
    return {to_end.samples, ended(nearer[0], to_end), ended(farther[0], from_beyond)};
}

}  // namespace lumi
