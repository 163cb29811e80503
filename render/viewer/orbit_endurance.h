#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "calib/work/progress.h"
#include "render/frame/frame.h"
#include "render/viewer/window.h"

namespace lumi {

/// A hand does not go on to the next photograph sooner.
inline constexpr double kShortestTurn_s = 0.5;

/// How long the window is turned about its scene, and how.
struct OrbitOptions {
    double seconds = 600.0;
    /// What memory grows by in that time is not counted: buffers grow to what the largest frame
    /// needs, and programs are compiled when they are first used.
    double warm_up_s = 60.0;
    /// All photographs are gone to in that time, and again and again; at least kShortestTurn_s
    /// each.
    double round_s = 50.0;
    /// At each photograph the eye is dragged to and fro in one after the other, and then rests.
    std::vector<RenderMode> modes = {RenderMode::kPerPixel, RenderMode::kAdaptive};
};

/// What the process held, and when.
struct MemorySample {
    double seconds = 0.0;
    std::uint64_t moving_bytes = 0;  ///< At the end of a drag.
    std::uint64_t bytes = 0;         ///< At rest after it.
};

struct OrbitReport {
    int frames = 0;
    double seconds = 0.0;
    double median_frame_ms = 0.0;  ///< While moving, in whatever size the window chose for it.
    double p95_frame_ms = 0.0;
    double longest_frame_ms = 0.0;
    int gl_errors = 0;
    std::vector<MemorySample> memory;  ///< At each photograph.

    /// At rest, between the first photograph that was left after `warm_up_s` and the last; nothing
    /// of fewer than two.
    [[nodiscard]] std::optional<std::int64_t> growth_bytes(double warm_up_s) const;
};

/// Steers the window as a hand with a mouse would, for as long as is asked, and watches its memory
/// and OpenGL's errors. Throws what `ViewerWindow::step` does; Error E-INTERRUPTED; E-ORBIT-STILL
/// where the eye did not move, as the cursor lies over the panel; E-ORBIT-CLOSED where somebody
/// closed the window; E-ORBIT-MEMORY where the system does not tell what memory is in use.
[[nodiscard]] OrbitReport orbit_window(ViewerWindow& window, std::size_t photographs,
                                       const OrbitOptions& options, Progress& progress);

}  // namespace lumi
