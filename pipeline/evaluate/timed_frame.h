#pragma once

#include <functional>
#include <vector>

#include "render/frame/frame.h"
#include "render/renderer/offscreen_renderer.h"

namespace lumi {

/// Wall and CPU times of repeated frames, milliseconds; CPU over all threads of the process.
struct RepeatedTimes {
    std::vector<double> wall_ms;
    std::vector<double> cpu_ms;
};

/// Draws so many times.
[[nodiscard]] RepeatedTimes times_of(int repetitions, const std::function<void()>& draw);

/// A frame, and the times it took.
struct TimedFrame {
    Frame frame;
    RepeatedTimes times;
};

/// Draws so many times, at least once, what an eye sees that comes there: each frame is made anew
/// (LumigraphRenderer::forget_frame). One frame before them warms up and is not timed. Throws Error
/// (E-GL-...).
[[nodiscard]] TimedFrame timed_frame(OffscreenRenderer& renderer, const Eye& eye,
                                     const RenderOptions& options, int repetitions);

}  // namespace lumi
