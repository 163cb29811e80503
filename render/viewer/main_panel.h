#pragma once

#include <optional>
#include <vector>

#include "render/viewer/commands.h"
#include "render/viewer/comparison.h"
#include "render/viewer/frame_statistics.h"
#include "render/viewer/panel_place.h"

namespace lumi {

/// The panel with modes, what else can be chosen, and figures, in a frame of Dear ImGui; a click
/// may change the state. Its height leaves `status_height`, in the window system's units, free at
/// the bottom. `compared` lies over the picture where it is compared. Returns where the panel lies.
PanelPlace show_main_panel(const Lumigraph& lumigraph, const std::vector<HeldOutView>& held_out,
                           const std::optional<PictureOverlay>& compared,
                           const FrameStatistics& statistics, float status_height,
                           ViewerState& state);

}  // namespace lumi
