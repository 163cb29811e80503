#include "render/viewer/panels.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "calib/work/printable.h"

namespace lumi {
namespace {

void show_modes(RenderOptions& render) {
    for (const RenderMode mode : all_render_modes()) {
        if (ImGui::RadioButton(name_of(mode).c_str(), render.mode == mode)) render.mode = mode;
    }
    ImGui::Separator();
    for (const DebugPicture picture : all_debug_pictures()) {
        const std::string label =
            picture == DebugPicture::kNone ? "picture" : "show " + name_of(picture);
        if (ImGui::RadioButton(label.c_str(), render.debug_picture == picture)) {
            render.debug_picture = picture;
        }
    }
    ImGui::Separator();
    ImGui::Checkbox("occlusion correction", &render.correct_occlusion);
    ImGui::Checkbox("fade beyond the capture", &render.fade_beyond_capture);
    ImGui::Checkbox("guess what lies around it", &render.guess_surroundings);
}

/// Frames a second that `adaptive` keeps while the eye moves.
void show_budget(ViewerState& state) {
    if (state.render.mode != RenderMode::kAdaptive) return;
    constexpr float kMost = 120.0F;
    auto wanted = static_cast<float>(state.frames_per_second);
    ImGui::SetNextItemWidth(120);
    if (ImGui::SliderFloat("moving", &wanted, 0.0F, kMost, wanted > 0 ? "%.0f frames/s" : "any"))
        state.frames_per_second = static_cast<double>(wanted);
}

void show_photographs(const Lumigraph& lumigraph, ViewerState& state) {
    const auto index = static_cast<std::size_t>(state.view_index);
    if (!ImGui::BeginCombo("##photograph", printable(lumigraph.views[index].name).c_str())) return;
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(printable(lumigraph.views[i].name).c_str(), i == index)) {
            go_to_photograph(static_cast<int>(i), lumigraph, state);
        }
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

/// Packages that were opened before.
void show_recent(ViewerState& state) {
    if (state.recent_packages.empty()) return;
    if (!ImGui::BeginCombo("##recent", "open again")) return;
    for (std::size_t i = 0; i < state.recent_packages.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(printable(state.recent_packages[i].string()).c_str()))
            state.package_to_open = state.recent_packages[i];
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

/// One button for each planned photograph, and the way to the one that is stood at.
void show_plan(const Lumigraph& lumigraph, ViewerState& state) {
    if (state.planned.empty()) return;
    ImGui::Separator();
    ImGui::TextUnformatted("photograph next");
    for (int i = 0; i < static_cast<int>(state.planned.size()); ++i) {
        if (i > 0) ImGui::SameLine();
        if (ImGui::Button(std::to_string(i + 1).c_str())) go_to_planned(i, lumigraph, state);
    }
    if (state.planned_index < 0) return;
    ImGui::PushTextWrapPos(240);
    ImGui::TextUnformatted(
        printable(state.planned[static_cast<std::size_t>(state.planned_index)].words).c_str());
    ImGui::PopTextWrapPos();
}

/// One button for each held-out photograph, and what is shown of it.
void show_comparison(const Lumigraph& lumigraph, const std::vector<HeldOutView>& held_out,
                     bool is_compared, ViewerState& state) {
    if (held_out.empty()) return;
    ImGui::Separator();
    const char* const label =
        is_compared ? held_out[static_cast<std::size_t>(state.compared_index)].name.c_str()
                    : "compare with a photograph";
    if (ImGui::BeginCombo("##held out", printable(label).c_str())) {
        for (int i = 0; i < static_cast<int>(held_out.size()); ++i) {
            ImGui::PushID(i);
            if (ImGui::Selectable(printable(held_out[static_cast<std::size_t>(i)].name).c_str(),
                                  is_compared && i == state.compared_index)) {
                go_to_held_out(i, held_out, lumigraph, state);
            }
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    if (!is_compared) return;
    ImGui::Checkbox("difference, four times", &state.shows_difference);
    if (state.shows_difference) return;
    auto share = static_cast<float>(state.compared_share);
    ImGui::SetNextItemWidth(120);
    if (ImGui::SliderFloat("photograph", &share, 0.0F, 1.0F, "%.2f"))
        state.compared_share = static_cast<double>(share);
}

/// Behind the panels; the photograph ends in a line.
void show_overlay(const PictureOverlay& overlay) {
    // ImGui measures in the window system's units.
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const auto at = [&](double x_px, double y_px) {
        return ImVec2(static_cast<float>(x_px) / scale.x, static_cast<float>(y_px) / scale.y);
    };
    const double end_px =
        overlay.low_px.x() + overlay.share * (overlay.high_px.x() - overlay.low_px.x());
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    list->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(overlay.texture)),
                   at(overlay.low_px.x(), overlay.low_px.y()), at(end_px, overlay.high_px.y()),
                   {0, 0}, {static_cast<float>(overlay.share), 1});
    if (overlay.share < 1)
        list->AddLine(at(end_px, overlay.low_px.y()), at(end_px, overlay.high_px.y()),
                      IM_COL32_WHITE);
}

void show_statistics(const Lumigraph& lumigraph, const FrameStatistics& statistics) {
    ImGui::Text("%.1f ms a frame", statistics.frame_ms);
    const std::vector<float>& recent = statistics.recent_frames_ms;
    if (!recent.empty()) {
        ImGui::PlotLines("##frames", recent.data(), static_cast<int>(recent.size()), 0, nullptr,
                         0.0F, *std::max_element(recent.begin(), recent.end()), {240, 36});
    }
    ImGui::Text("%zu triangles", statistics.triangles);
    ImGui::Text("%d x %d pixels", statistics.width_px, statistics.height_px);
    ImGui::Text("%zu photographs, %zu faces", lumigraph.views.size(), lumigraph.mesh.faces.size());
    ImGui::TextWrapped("%s", statistics.gl_description.c_str());
    if (!statistics.message.empty()) {
        ImGui::Separator();
        ImGui::TextWrapped("%s", printable(statistics.message).c_str());
    }
}

void show_panel(const Lumigraph& lumigraph, const std::vector<HeldOutView>& held_out,
                bool is_compared, const FrameStatistics& statistics, ViewerState& state) {
    ImGui::SetNextWindowPos({10, 10}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({260, 0}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("lumi", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
        show_modes(state.render);
        show_budget(state);
        ImGui::Separator();
        show_photographs(lumigraph, state);
        show_plan(lumigraph, state);
        show_comparison(lumigraph, held_out, is_compared, state);
        show_recent(state);
        ImGui::Separator();
        show_statistics(lumigraph, statistics);
        ImGui::Separator();
        ImGui::TextUnformatted("H: keys and mouse");
    }
    ImGui::End();
}

void show_help(bool& open) {
    constexpr std::array<std::array<const char*, 2>, 8> kMouse{{
        {"left drag", "turn about what is in the middle"},
        {"right drag", "move sideways (also middle, Shift+left)"},
        {"Ctrl+left drag", "look around"},
        {"wheel", "closer, further"},
        {"W A S D", "fly forwards, left, backwards, right"},
        {"Q E", "fly down, up"},
        {"Shift", "fly fast"},
        {"drop a package", "open it"},
    }};
    ImGui::SetNextWindowPos({290, 10}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("keys and mouse", &open, ImGuiWindowFlags_AlwaysAutoResize) &&
        ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        const auto row = [](const char* what, const char* does) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(what);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(does);
        };
        for (const auto& [what, does] : kMouse) row(what, does);
        for (const KeyBinding& binding : key_bindings()) row(binding.shown, binding.help);
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace

Panels::Panels(const GlfwWindow& window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // Leaves no file behind where lumi was started.
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Panels::~Panels() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Panels::draw(const Lumigraph& lumigraph, const std::vector<HeldOutView>& held_out,
                  const std::optional<PictureOverlay>& overlay, const FrameStatistics& statistics,
                  ViewerState& state) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    if (overlay) show_overlay(*overlay);
    if (state.shows_panel) show_panel(lumigraph, held_out, overlay.has_value(), statistics, state);
    if (state.shows_help) show_help(state.shows_help);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool Panels::takes_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
bool Panels::takes_keys() const { return ImGui::GetIO().WantTextInput; }

}  // namespace lumi
