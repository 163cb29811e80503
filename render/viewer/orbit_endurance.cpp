#include "render/viewer/orbit_endurance.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "calib/work/error.h"
#include "calib/work/median.h"
#include "calib/work/process_memory.h"
#include "render/lumigraph/same_eye.h"
#include "render/viewer/window_input.h"

namespace lumi {
namespace {

using Clock = std::chrono::steady_clock;

/// Longer than the window takes for granted that the hand only hesitates.
constexpr double kRest_s = 0.25;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::uint64_t memory_now() {
    if (const auto bytes = memory_in_use()) return *bytes;
    throw Error(ErrorKind::kBadInput, "E-ORBIT-MEMORY",
                "the system does not tell what memory is in use", "run it where /proc is mounted");
}

/// An ellipse once every four seconds, as a hand draws it: back where it began, so that the eye
/// stays about its photograph.
WindowInput drag_at(double seconds, double last_seconds) {
    constexpr double kPeriod_s = 4.0;
    const Eigen::Vector2d reach_px(120.0, 40.0);
    const auto cursor_at = [&](double when) -> Eigen::Vector2d {
        const double turn = 2 * std::numbers::pi * when / kPeriod_s;
        return reach_px.cwiseProduct(Eigen::Vector2d(std::sin(turn), 1 - std::cos(turn)));
    };
    WindowInput input;
    input.left_button = true;
    input.drag_px = cursor_at(seconds) - cursor_at(last_seconds);
    return input;
}

/// Shows one frame, without a hand on the mouse where there is no input.
void step(ViewerWindow& window, const WindowInput* input, OrbitReport& report) {
    if (!window.step(input))
        throw Error(ErrorKind::kInterrupted, "E-ORBIT-CLOSED",
                    "the window was closed before its time was over", "leave it open");
    while (glGetError() != GL_NO_ERROR) ++report.gl_errors;
    ++report.frames;
}

/// Drags the eye about, for two frames at least, as the first does not move it; whether it
/// followed.
bool drag(ViewerWindow& window, double seconds, OrbitReport& report,
          std::vector<double>& moving_frames_ms) {
    const Eye begun_at = window.state().navigation.eye;
    const Clock::time_point start = Clock::now();
    bool has_moved = false;
    double last_s = 0.0;
    double now_s = 0.0;
    for (int frame = 0; frame < 2 || now_s < seconds; ++frame, now_s = seconds_since(start)) {
        const WindowInput drag = drag_at(now_s, last_s);
        step(window, &drag, report);
        moving_frames_ms.push_back(window.statistics().frame_ms);
        has_moved = has_moved || !is_same_eye(window.state().navigation.eye, begun_at);
        last_s = now_s;
    }
    return has_moved;
}

/// Goes to the next photograph, turns about its middle in each mode, and rests; what was held.
MemorySample take_turn(ViewerWindow& window, const OrbitOptions& options, double seconds,
                       OrbitReport& report, std::vector<double>& moving_frames_ms) {
    const Clock::time_point start = Clock::now();
    window.go_to_photograph(window.state().view_index + 1);
    const WindowInput nothing;
    step(window, &nothing, report);
    const double drag_s = (seconds - kRest_s) / static_cast<double>(options.modes.size());
    for (const RenderMode mode : options.modes) {
        window.state().render.mode = mode;
        if (drag(window, drag_s, report, moving_frames_ms)) continue;
        throw Error(ErrorKind::kBadInput, "E-ORBIT-STILL",
                    "the eye did not follow the drag, as the cursor lies over the panel",
                    "move the cursor out of the window");
    }
    const std::uint64_t moving_bytes = memory_now();
    do {
        step(window, nullptr, report);
    } while (seconds_since(start) < seconds);
    return {0.0, moving_bytes, memory_now()};
}

}  // namespace

std::optional<std::int64_t> OrbitReport::growth_bytes(double warm_up_s) const {
    const auto first = std::find_if(memory.begin(), memory.end(), [&](const MemorySample& sample) {
        return sample.seconds >= warm_up_s;
    });
    if (memory.end() - first < 2) return std::nullopt;
    return static_cast<std::int64_t>(memory.back().bytes) - static_cast<std::int64_t>(first->bytes);
}

OrbitReport orbit_window(ViewerWindow& window, std::size_t photographs, const OrbitOptions& options,
                         Progress& progress) {
    OrbitReport report;
    const double turn_s =
        std::max(kShortestTurn_s, options.round_s / static_cast<double>(photographs));
    const auto turns = static_cast<std::size_t>(std::ceil(options.seconds / turn_s));
    // What is remembered must not be what grows.
    std::vector<double> moving_frames_ms;
    constexpr double kMostFramesPerSecond = 200.0;
    moving_frames_ms.reserve(static_cast<std::size_t>(kMostFramesPerSecond * options.seconds));
    report.memory.reserve(turns);

    progress.begin("photographs to turn about", turns);
    const Clock::time_point start = Clock::now();
    while (report.memory.size() < turns) {
        report.memory.push_back(take_turn(window, options, turn_s, report, moving_frames_ms));
        report.memory.back().seconds = seconds_since(start);
        progress.advance();
        progress.throw_if_interrupted();
    }
    report.seconds = seconds_since(start);
    report.median_frame_ms = quantile_of(moving_frames_ms, 0.5);
    report.p95_frame_ms = quantile_of(moving_frames_ms, 0.95);
    report.longest_frame_ms = quantile_of(moving_frames_ms, 1.0);
    return report;
}

}  // namespace lumi
