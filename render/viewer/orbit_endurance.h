#pragma once

#include <cstdint>
#include <vector>

#include "calib/work/progress.h"
#include "render/frame/frame.h"
#include "render/viewer/window.h"

namespace lumi {

/// How long the window is turned about its scene, and how.
struct OrbitOptions {
    double seconds = 600.0;
    double warm_up_s = 60.0;  ///< What memory grows by in that time is not counted.
    /// Drawn in turn, each from the next photograph on, dragged to and fro and then at rest.
    std::vector<RenderMode> modes = {RenderMode::kPerPixel, RenderMode::kAdaptive};
    double drag_s = 8.0;  ///< Of each turn.
    double rest_s = 1.0;
};

/// What the process held, and when.
struct MemorySample {
    double seconds = 0.0;
    std::uint64_t moving_bytes = 0;  ///< At the end of the drag.
    std::uint64_t bytes = 0;         ///< At rest after it.
};

struct OrbitReport {
    int frames = 0;
    double seconds = 0.0;
    double median_frame_ms = 0.0;  ///< While moving, in whatever size the window chose for it.
    double p95_frame_ms = 0.0;
    int gl_errors = 0;
    std::vector<MemorySample> memory;  ///< At each turn's end.

    /// At rest, between the first turn that ended after `warm_up_s` and the last; 0 of fewer than
    /// two.
    [[nodiscard]] std::int64_t growth_bytes(double warm_up_s) const;
};

/// Steers the window as a hand with a mouse would, for as long as is asked, and watches its memory
/// and OpenGL's errors. Throws what `ViewerWindow::step` does; Error E-INTERRUPTED; E-ORBIT-STILL
/// where the eye did not move, as the cursor lies over the panel; E-ORBIT-CLOSED where somebody
/// closed the window; E-ORBIT-MEMORY where the system does not tell what memory is in use.
[[nodiscard]] OrbitReport orbit_window(ViewerWindow& window, const OrbitOptions& options,
                                       Progress& progress);

}  // namespace lumi
