#include "render/viewer/main_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <string>

#include "calib/work/formatted.h"
#include "calib/work/printable.h"
#include "render/bench/occlusion_share.h"
#include "render/frame/mode_of_a_paper.h"
#include "render/viewer/black_picture.h"
#include "render/viewer/moving_resolution.h"

namespace lumi {
namespace {

/// For letters as high as ImGui's own.
constexpr float kPanelWidth = 250;
constexpr float kPanelMargin = 10;
constexpr float kSliderWidth = 120;
constexpr float kGraphHeight = 36;

/// For the letters that there are.
float scaled(float length) {
    constexpr float kLetters = 13;
    return std::round(length * ImGui::GetFontSize() / kLetters);
}

/// As the mode is drawn of this Lumigraph.
bool is_drawn_as_a_paper_says(const RenderOptions& render, const Lumigraph& lumigraph) {
    return is_of_a_paper(possible_options(render, lumigraph.has_depth()).mode);
}

/// A list over the panel's width that opens with a click, to be ended as a combo is; Esc closes it.
bool begin_list(const char* label, const std::string& chosen) {
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (!ImGui::BeginCombo(label, chosen.c_str())) return false;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
    return true;
}

/// Greyed, in as many lines as it takes.
void show_caption(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

/// Two in a row.
void show_modes(RenderOptions& render) {
    const std::vector<RenderMode> all = all_render_modes();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i % 2 == 1) ImGui::SameLine(scaled(kPanelWidth) / 2);
        if (ImGui::RadioButton(name_of(all[i]).c_str(), render.mode == all[i]))
            render.mode = all[i];
    }
}

/// Greyed where it changes nothing, which `where_not` says to a cursor over it.
void checkbox(const char* label, bool has_effect, const std::string& where_not, bool& value) {
    ImGui::BeginDisabled(!has_effect);
    ImGui::Checkbox(label, &value);
    ImGui::EndDisabled();
    if (!has_effect && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("without effect %s", where_not.c_str());
}

std::string words_for(DebugPicture picture) {
    return picture == DebugPicture::kNone ? "the picture" : "show " + name_of(picture);
}

void show_picture(const Lumigraph& lumigraph, ViewerState& state) {
    RenderOptions& render = state.render;
    if (begin_list("##picture", words_for(render.debug_picture))) {
        for (const DebugPicture picture : all_debug_pictures()) {
            if (ImGui::Selectable(words_for(picture).c_str(), render.debug_picture == picture))
                render.debug_picture = picture;
        }
        ImGui::EndCombo();
    }
    if (const std::string why = why_black(lumigraph, render); !why.empty()) show_caption(why);
    const std::string in_mode = "in " + name_of(render.mode);
    const bool as_a_paper_says = is_drawn_as_a_paper_says(render, lumigraph);
    checkbox("occlusion correction", corrects_occlusion(lumigraph, render),
             lumigraph.has_depth() ? in_mode : "in a package without depth",
             render.correct_occlusion);
    checkbox("fade beyond the capture", !as_a_paper_says, in_mode, render.fade_beyond_capture);
    checkbox("guess what lies around it", !as_a_paper_says && !render.fade_beyond_capture,
             as_a_paper_says ? in_mode : "where the capture fades", render.guess_surroundings);
    bool evens = state.exposures == Exposures::kEvened;
    checkbox("even out exposures", !state.package.empty(), "without a package to read again",
             evens);
    state.exposures = evens ? Exposures::kEvened : Exposures::kAsTaken;
}

void show_photographs(const Lumigraph& lumigraph, ViewerState& state) {
    const std::optional<int> here = photograph_stood_at(lumigraph, state);
    const auto name_of_photograph = [&](int i) {
        return printable(lumigraph.views[static_cast<std::size_t>(i)].name);
    };
    const std::string chosen =
        here ? name_of_photograph(*here)
             : "nearest: " + name_of_photograph(nearest_view(lumigraph, state.navigation.eye));
    if (!begin_list("##photograph", chosen)) return;
    for (int i = 0; i < static_cast<int>(lumigraph.views.size()); ++i) {
        ImGui::PushID(i);
        if (ImGui::Selectable(name_of_photograph(i).c_str(), i == here))
            go_to_photograph(i, lumigraph, state);
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

/// Packages that were opened before.
void show_recent(ViewerState& state) {
    if (state.recent_packages.empty()) return;
    if (!begin_list("##recent", "open again")) return;
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
    ImGui::TextUnformatted("photograph next");
    for (int i = 0; i < static_cast<int>(state.planned.size()); ++i) {
        ImGui::SameLine();
        if (ImGui::Button(std::to_string(i + 1).c_str())) go_to_planned(i, lumigraph, state);
    }
    if (state.planned_index < 0) return;
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(
        printable(state.planned[static_cast<std::size_t>(state.planned_index)].words).c_str());
    ImGui::PopTextWrapPos();
}

/// One button for each held-out photograph, and what is shown of it.
void show_comparison(const Lumigraph& lumigraph, const std::vector<HeldOutView>& held_out,
                     const std::optional<PictureOverlay>& compared, ViewerState& state) {
    if (held_out.empty()) return;
    const std::string label = compared
                                  ? held_out[static_cast<std::size_t>(state.compared_index)].name
                                  : "compare with a photograph";
    if (begin_list("##held out", printable(label))) {
        for (int i = 0; i < static_cast<int>(held_out.size()); ++i) {
            ImGui::PushID(i);
            if (ImGui::Selectable(printable(held_out[static_cast<std::size_t>(i)].name).c_str(),
                                  compared && i == state.compared_index)) {
                go_to_held_out(i, held_out, lumigraph, state);
            }
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    if (!compared) return;
    if (!compared->likeness.empty()) ImGui::TextWrapped("%s", compared->likeness.c_str());
    ImGui::Checkbox("difference, four times", &state.shows_difference);
    if (state.shows_difference) return;
    auto share = static_cast<float>(state.compared_share);
    ImGui::SetNextItemWidth(scaled(kSliderWidth));
    if (ImGui::SliderFloat("photograph", &share, 0.0F, 1.0F, "%.2f"))
        state.compared_share = static_cast<double>(share);
}

/// The eye's path, and how smoothly frames follow it.
void show_movement(ViewerState& state) {
    if (ImGui::Button(state.records_path ? "write path" : "record path"))
        state.records_path = !state.records_path;
    ImGui::SameLine();
    ImGui::BeginDisabled(!state.has_path);
    if (ImGui::Button(state.replays_path ? "stop" : "replay path"))
        state.replays_path = !state.replays_path;
    ImGui::EndDisabled();
    if (state.has_unwritten_path && ImGui::Button("write the path again"))
        state.writes_path_again = true;
    constexpr float kMost = 120.0F;
    auto wanted = static_cast<float>(state.frames_per_second);
    ImGui::SetNextItemWidth(scaled(kSliderWidth));
    if (ImGui::SliderFloat("frames/s", &wanted, 0.0F, kMost, wanted > 0 ? "%.0f" : "default"))
        state.frames_per_second = static_cast<double>(wanted);
    const bool drops_triangles =
        state.render.mode == RenderMode::kAdaptive && state.frames_per_second > 0;
    const double kept =
        state.frames_per_second > 0 ? state.frames_per_second : MovingResolution::kFramesPerSecond;
    show_caption(
        formatted("%.0f by coarser frames%s", kept, drops_triangles ? ", fewer triangles" : ""));
}

void show_figures(const Lumigraph& lumigraph, const FrameStatistics& statistics) {
    const std::vector<float>& recent = statistics.recent_frames_ms;
    if (!recent.empty()) {
        const float most_ms = *std::max_element(recent.begin(), recent.end());
        const std::string words =
            formatted("%.1f ms, at most %.0f", statistics.frame_ms, static_cast<double>(most_ms));
        // A width within the plot's own size must not be negative.
        ImGui::SetNextItemWidth(-FLT_MIN);
        ImGui::PlotLines("##frames", recent.data(), static_cast<int>(recent.size()), 0,
                         words.c_str(), 0.0F, most_ms, {0, scaled(kGraphHeight)});
    }
    ImGui::Text("%zu photographs, %zu faces", lumigraph.views.size(), lumigraph.mesh.faces.size());
    ImGui::TextWrapped("%s", statistics.gl_description.c_str());
}

}  // namespace

PanelPlace show_main_panel(const Lumigraph& lumigraph, const std::vector<HeldOutView>& held_out,
                           const std::optional<PictureOverlay>& compared,
                           const FrameStatistics& statistics, float status_height,
                           ViewerState& state) {
    const float margin = scaled(kPanelMargin);
    const float width = scaled(kPanelWidth);
    const float room = ImGui::GetIO().DisplaySize.y - 2 * margin - status_height;
    ImGui::SetNextWindowPos({margin, margin}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, std::max(room, scaled(100.0F))});
    if (ImGui::Begin("lumi", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
        constexpr ImGuiTreeNodeFlags kOpen = ImGuiTreeNodeFlags_DefaultOpen;
        if (ImGui::CollapsingHeader("mode", kOpen)) show_modes(state.render);
        if (ImGui::CollapsingHeader("picture", kOpen)) show_picture(lumigraph, state);
        if (ImGui::CollapsingHeader("photographs", kOpen)) {
            show_photographs(lumigraph, state);
            show_plan(lumigraph, state);
            show_comparison(lumigraph, held_out, compared, state);
            show_recent(state);
        }
        if (ImGui::CollapsingHeader("movement", kOpen)) show_movement(state);
        if (ImGui::CollapsingHeader("figures", kOpen)) show_figures(lumigraph, statistics);
    }
    const PanelPlace place = place_of_panel();
    ImGui::End();
    return place;
}

}  // namespace lumi
