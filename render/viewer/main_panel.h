#pragma once

#include <vector>

#include "render/viewer/commands.h"
#include "render/viewer/frame_statistics.h"

namespace lumi {

/// The panel with modes, what else can be chosen, and figures, in a frame of Dear ImGui; a click
/// may change the state. Its height leaves `status_height`, in the window system's units, free at
/// the bottom.
void show_main_panel(const Lumigraph& lumigraph, const std::vector<HeldOutView>& held_out,
                     bool is_compared, const FrameStatistics& statistics, float status_height,
                     ViewerState& state);

}  // namespace lumi
