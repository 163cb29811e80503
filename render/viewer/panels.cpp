#include "render/viewer/panels.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <array>
#include <cfloat>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "calib/work/counted.h"
#include "calib/work/formatted.h"
#include "calib/work/printable.h"
#include "render/viewer/main_panel.h"

namespace lumi {
namespace {

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

/// At the bottom over the whole width; how high it is.
float show_status(const std::string& text) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0, window.y}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSizeConstraints({window.x, 0}, {window.x, FLT_MAX});
    constexpr ImGuiWindowFlags kPlain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                        ImGuiWindowFlags_NoFocusOnAppearing |
                                        ImGuiWindowFlags_AlwaysAutoResize;
    float height = 0;
    if (ImGui::Begin("status", nullptr, kPlain)) {
        ImGui::TextWrapped("%s", printable(text).c_str());
        height = ImGui::GetWindowHeight();
    }
    ImGui::End();
    return height;
}

/// What there is to tell, side by side.
std::string beside(const std::string& one, const std::string& other) {
    return one + (one.empty() || other.empty() ? "" : " | ") + other;
}

std::string status_text(const FrameStatistics& statistics, RenderMode mode) {
    // `perpixel` draws faces of the camera mesh, whose number tells nothing of the picture.
    const std::string triangles =
        mode == RenderMode::kPerPixel ? "" : counted(statistics.triangles, "triangle") + ", ";
    const std::string figures =
        formatted("H: keys and mouse | %.1f ms, ", statistics.frame_ms) + triangles +
        formatted("%d x %d pixels", statistics.width_px, statistics.height_px);
    return beside(beside(figures, statistics.recording), statistics.message);
}

/// What to press, and what it does: of the mouse, and of all keys, those of a command together.
std::vector<std::array<std::string, 2>> help_rows() {
    std::vector<std::array<std::string, 2>> rows{
        {"left drag", "turn about what is in the middle"},
        {"right drag", "move sideways (middle, Shift+left)"},
        {"Ctrl+left drag", "look around"},
        {"wheel", "closer, further"},
        {"W A S D", "fly forwards, left, back, right"},
        {"Q E", "fly down, up"},
        {"Shift", "fly fast"},
        {"drop a package", "open it"},
    };
    std::optional<Command> last;
    for (const KeyBinding& binding : key_bindings()) {
        if (std::exchange(last, binding.command) == binding.command) {
            rows.back()[0] += std::string(", ") + binding.shown;
        } else {
            rows.push_back({binding.shown, binding.help});
        }
    }
    return rows;
}

/// In two columns, to fit into the window.
void show_help(bool& open) {
    static const std::vector<std::array<std::string, 2>> rows = help_rows();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Appearing, {0.5F, 0.5F});
    if (ImGui::Begin("keys and mouse", &open, ImGuiWindowFlags_AlwaysAutoResize) &&
        ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit)) {
        const std::size_t half = (rows.size() + 1) / 2;
        for (std::size_t i = 0; i < half; ++i) {
            ImGui::TableNextRow();
            for (const std::size_t row : {i, i + half}) {
                for (std::size_t part = 0; row < rows.size() && part < 2; ++part) {
                    ImGui::TableNextColumn();
                    ImGui::TextUnformatted(rows[row][part].c_str());
                }
            }
        }
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
    constexpr double kMessageAlone_s = 4.0;
    if (std::exchange(message_, statistics.message) != statistics.message)
        message_began_s_ = ImGui::GetTime();
    const bool is_news = !message_.empty() && ImGui::GetTime() < message_began_s_ + kMessageAlone_s;
    if (state.shows_panel) {
        const float status_height = show_status(status_text(statistics, state.render.mode));
        show_main_panel(lumigraph, held_out, overlay, statistics, status_height, state);
    } else if (is_news || !statistics.recording.empty()) {
        show_status(beside(statistics.recording, is_news ? message_ : ""));
    }
    if (state.shows_help) show_help(state.shows_help);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool Panels::takes_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
bool Panels::has_open_list() const { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup); }
bool Panels::takes_keys() const { return ImGui::GetIO().WantTextInput; }

}  // namespace lumi
