#include "pipeline/evaluate/timed_frame.h"

#include <algorithm>

#include "calib/work/stopwatch.h"

namespace lumi {

RepeatedTimes times_of(int repetitions, const std::function<void()>& draw) {
    RepeatedTimes times;
    for (int i = 0; i < repetitions; ++i) {
        const Stopwatch stopwatch;
        draw();
        const Cost cost = stopwatch.elapsed();
        times.wall_ms.push_back(1000.0 * cost.wall_s);
        times.cpu_ms.push_back(1000.0 * cost.cpu_s);
    }
    return times;
}

TimedFrame timed_frame(OffscreenRenderer& renderer, const Eye& eye, const RenderOptions& options,
                       int repetitions) {
    TimedFrame timed{renderer.draw(eye, options), {}};
    timed.times = times_of(std::max(1, repetitions), [&] {
        renderer.forget_frame();
        timed.frame = renderer.draw(eye, options);
    });
    return timed;
}

}  // namespace lumi
