#include "render/viewer/panels.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <iterator>
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
    const double texture_width = overlay.texture_high.x() - overlay.texture_low.x();
    const auto of_texture = [](const Eigen::Vector2d& share) {
        return ImVec2(static_cast<float>(share.x()), static_cast<float>(share.y()));
    };
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    list->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(overlay.texture)),
                   at(overlay.low_px.x(), overlay.low_px.y()), at(end_px, overlay.high_px.y()),
                   of_texture(overlay.texture_low),
                   of_texture({overlay.texture_low.x() + overlay.share * texture_width,
                               overlay.texture_high.y()}));
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

std::string status_text(const FrameStatistics& statistics, bool is_news, RenderMode mode) {
    // `perpixel` draws faces of the camera mesh, whose number tells nothing of the picture.
    const std::string triangles =
        mode == RenderMode::kPerPixel ? "" : counted(statistics.triangles, "triangle") + ", ";
    const std::string figures =
        formatted("H: keys and mouse | %.1f ms, ", statistics.frame_ms) + triangles +
        formatted("%d x %d pixels", statistics.width_px, statistics.height_px);
    return beside(beside(figures, statistics.recording), is_news ? statistics.message : "");
}

/// Of several keys, by their places.
std::string shown_places(std::initializer_list<int> places, const KeyLabels& labels) {
    std::string shown;
    for (const int place : places) shown += (shown.empty() ? "" : " ") + shown_place(place, labels);
    return shown;
}

/// What to press, and what it does: of the mouse, and of all keys, those of a command together.
std::vector<std::array<std::string, 2>> help_rows(const KeyLabels& labels) {
    std::vector<std::array<std::string, 2>> rows{
        {"left drag", "turn about what is in the middle"},
        {"double click", "turn about what is there from then on"},
        {"right drag", "move sideways (middle, Shift+left)"},
        {"Ctrl+left drag", "look around"},
        {"wheel", "closer, further; comparing: enlarge"},
        {shown_places({'W', 'A', 'S', 'D'}, labels), "fly forwards, left, back, right"},
        {shown_places({'Q', 'E'}, labels), "fly down, up"},
        {"Shift", "fly fast"},
        {"drop a package", "open it, or that of a workspace"},
        {"drop a screenshot", "stand there; a path: replay it"},
    };
    std::optional<Command> last;
    for (const KeyBinding& binding : key_bindings()) {
        if (std::exchange(last, binding.command) == binding.command) {
            rows.back()[0] += ", " + shown_key(binding, labels);
        } else {
            rows.push_back({shown_key(binding, labels), binding.help});
        }
    }
    return rows;
}

/// Whether a key or a button was pressed or the wheel turned, by ImGui's account.
bool does_something() {
    const ImGuiIO& io = ImGui::GetIO();
    return ImGui::IsAnyMouseDown() || io.MouseWheel != 0 ||
           std::find(std::begin(io.KeysDown), std::end(io.KeysDown), true) != std::end(io.KeysDown);
}

/// Characters that ImGui's own font lacks, of a system's font where there is one.
void add_other_alphabets(ImFontAtlas& fonts, float size) {
    static constexpr std::array<ImWchar, 5> kGreekAndCyrillic{0x0370, 0x03FF, 0x0400, 0x052F, 0};
    static constexpr std::array<ImWchar, 3> kMoreLatin{0x0100, 0x024F, 0};
    for (const char* const file :
         {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf",
          "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
          "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"}) {
        if (::access(file, R_OK) != 0) continue;
        ImFontConfig config;
        config.MergeMode = true;
        fonts.AddFontFromFileTTF(file, size, &config, kMoreLatin.data());
        fonts.AddFontFromFileTTF(file, size, &config, kGreekAndCyrillic.data());
        return;
    }
}

/// `scale`: of letters on an ordinary screen.
void set_sizes(float scale) {
    // Of whole pixels, as panels are: what is a part of one higher than its panel is scrolled.
    const float letters_px = std::round(13 * scale);
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    ImFontConfig config;
    config.SizePixels = letters_px;
    config.OversampleH = config.OversampleV = 1;  // It is drawn pixel by pixel.
    config.PixelSnapH = true;
    fonts.AddFontDefault(&config);
    add_other_alphabets(fonts, letters_px);
    ImGui::GetStyle().ScaleAllSizes(scale);
}

/// In two columns, to fit into the window.
void show_rows(const std::vector<std::array<std::string, 2>>& rows) {
    if (!ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit)) return;
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

}  // namespace

void Panels::show_help(bool& open) {
    if (help_rows_.empty()) help_rows_ = help_rows(label_of_key);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Appearing, {0.5F, 0.5F});
    if (ImGui::Begin("keys and mouse", &open, ImGuiWindowFlags_AlwaysAutoResize))
        show_rows(help_rows_);
    places_.push_back(place_of_panel());
    ImGui::End();
}

Panels::Panels(const GlfwWindow& window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // Leaves no file behind where lumi was started.
    set_sizes(window.content_scale());
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
    const bool has_news = is_news(statistics);
    places_.clear();
    if (state.shows_panel) {
        const float status_height =
            show_status(status_text(statistics, has_news, state.render.mode));
        places_.push_back(
            show_main_panel(lumigraph, held_out, overlay, statistics, status_height, state));
    } else if (has_news || !statistics.recording.empty()) {
        show_status(beside(statistics.recording, has_news ? statistics.message : ""));
    }
    // Another keyboard may be chosen meanwhile.
    if (!state.shows_help) help_rows_.clear();
    if (state.shows_help) show_help(state.shows_help);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool Panels::is_news(const FrameStatistics& statistics) {
    constexpr double kShortest_s = 4.0;
    if (std::exchange(messages_, statistics.messages) != statistics.messages) {
        message_began_s_ = ImGui::GetTime();
        is_over_ = false;
    }
    const bool is_old = ImGui::GetTime() >= message_began_s_ + kShortest_s;
    if (is_old && (!statistics.has_failed || does_something())) is_over_ = true;
    return !statistics.message.empty() && !is_over_;
}

bool Panels::takes_mouse(const std::optional<Eigen::Vector2d>& at_px) const {
    const ImGuiIO& io = ImGui::GetIO();
    if (!at_px) return io.WantCaptureMouse;
    const float x = static_cast<float>(at_px->x()) / io.DisplayFramebufferScale.x;
    const float y = static_cast<float>(at_px->y()) / io.DisplayFramebufferScale.y;
    return has_open_list() || std::any_of(places_.begin(), places_.end(),
                                          [&](const auto& place) { return place.holds(x, y); });
}
bool Panels::has_open_list() const { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup); }
bool Panels::takes_keys() const { return ImGui::GetIO().WantTextInput; }

}  // namespace lumi
