#pragma once

namespace lumi {

/// Where a panel lies, in the window system's units.
struct PanelPlace {
    float left = 0;
    float top = 0;
    float right = 0;
    float bottom = 0;

    [[nodiscard]] bool holds(float x, float y) const {
        return x >= left && x < right && y >= top && y < bottom;
    }
};

/// Of the one whose contents are being shown in a frame of Dear ImGui.
[[nodiscard]] PanelPlace place_of_panel();

}  // namespace lumi
