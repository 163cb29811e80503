#include "render/viewer/moving_resolution.h"

namespace lumi {

MovingResolution::MovingResolution(double frames_per_second)
    : target_ms_(1000 / (frames_per_second > 0 ? frames_per_second : kFramesPerSecond)) {}

void MovingResolution::measured(double scale, double frame_ms) {
    // Pixels are what costs; single slow frames are smoothed away.
    const double whole_ms = frame_ms / (scale * scale);
    constexpr double kWeightOfNew = 0.3;
    whole_frame_ms_ = whole_frame_ms_ == 0.0
                          ? whole_ms
                          : (1 - kWeightOfNew) * whole_frame_ms_ + kWeightOfNew * whole_ms;
}

double MovingResolution::scale_while_moving() const {
    // Few steps, so that the framebuffer is not made anew at each frame.
    double scale = 1.0;
    while (scale > kCoarsest && whole_frame_ms_ * scale * scale > target_ms_) scale *= 0.5;
    return scale;
}

}  // namespace lumi
