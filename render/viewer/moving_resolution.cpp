#include "render/viewer/moving_resolution.h"

#include <cmath>
#include <utility>

namespace lumi {

MovingResolution::MovingResolution(double frames_per_second)
    : target_ms_(1000 / (frames_per_second > 0 ? frames_per_second : kFramesPerSecond)) {}

void MovingResolution::measured(double scale, double frame_ms) {
    // What does not grow with pixels is taken to do so, too: a finer frame then takes no longer
    // than foreseen, and a coarser one is tried before a still coarser. Single slow frames are
    // smoothed away.
    const double whole_ms = frame_ms / (scale * scale);
    constexpr double kWeightOfNew = 0.3;
    whole_frame_ms_ = std::exchange(is_measured_, true)
                          ? (1 - kWeightOfNew) * whole_frame_ms_ + kWeightOfNew * whole_ms
                          : whole_ms;
}

void MovingResolution::guessed(double scale, double frame_ms) {
    if (!is_measured_) whole_frame_ms_ = frame_ms / (scale * scale);
}

double MovingResolution::scale_while_moving() const {
    // Few steps, each of half the pixels, so that the framebuffer is not made anew at each frame.
    int halvings = 0;
    const auto scale = [&] { return std::exp2(-0.5 * halvings); };
    while (scale() > kCoarsest && whole_frame_ms_ * scale() * scale() > target_ms_) ++halvings;
    return scale();
}

}  // namespace lumi
