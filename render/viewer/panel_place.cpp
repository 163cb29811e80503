#include "render/viewer/panel_place.h"

#include <imgui.h>

namespace lumi {

PanelPlace place_of_panel() {
    const ImVec2 at = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    return {at.x, at.y, at.x + size.x, at.y + size.y};
}

}  // namespace lumi
