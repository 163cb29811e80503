#include "render/viewer/commands.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "render/lumigraph/same_eye.h"
#include "render/paths/photograph_eye.h"

namespace lumi {
namespace {

constexpr std::array kBindings{
    KeyBinding{GLFW_KEY_1, false, Command::kLightField, "1", "lightfield: the scene is a plane"},
    KeyBinding{GLFW_KEY_2, false, Command::kPerPixel, "2", "perpixel: depth at each pixel"},
    KeyBinding{GLFW_KEY_3, false, Command::kAdaptive, "3", "adaptive: triangles by their error"},
    KeyBinding{GLFW_KEY_4, false, Command::kPaper2001, "4", "paper2001: the paper to the letter"},
    KeyBinding{GLFW_KEY_5, false, Command::kHeigl, "5", "heigl: views triangulated anew"},
    KeyBinding{GLFW_KEY_M, false, Command::kNextMode, "M", "next mode"},
    KeyBinding{GLFW_KEY_B, false, Command::kShowWeights, "B", "show the blending weights"},
    KeyBinding{GLFW_KEY_T, false, Command::kShowFaces, "T", "show the faces (triangles)"},
    KeyBinding{GLFW_KEY_Z, false, Command::kShowDepth, "Z", "show depth"},
    KeyBinding{GLFW_KEY_D, true, Command::kShowDepth, "Ctrl+D", "show depth"},
    KeyBinding{GLFW_KEY_C, false, Command::kShowConfidence, "C", "show the depth's confidence"},
    KeyBinding{GLFW_KEY_X, false, Command::kShowOcclusion, "X", "show what occlusion takes"},
    KeyBinding{GLFW_KEY_G, false, Command::kShowGrid, "G", "show the grid of triangles"},
    KeyBinding{GLFW_KEY_N, false, Command::kNextPicture, "N", "show the next of these"},
    KeyBinding{GLFW_KEY_O, false, Command::kOcclusion, "O", "occlusion correction on or off"},
    KeyBinding{GLFW_KEY_LEFT_BRACKET, false, Command::kPreviousPhotograph, "[",
               "stand at the previous photograph"},
    KeyBinding{GLFW_KEY_PAGE_UP, false, Command::kPreviousPhotograph, "Page up",
               "stand at the previous photograph"},
    KeyBinding{GLFW_KEY_RIGHT_BRACKET, false, Command::kNextPhotograph, "]",
               "stand at the next photograph"},
    KeyBinding{GLFW_KEY_PAGE_DOWN, false, Command::kNextPhotograph, "Page down",
               "stand at the next photograph"},
    KeyBinding{GLFW_KEY_HOME, false, Command::kNearestPhotograph, "Home",
               "stand at the nearest photograph"},
    KeyBinding{GLFW_KEY_K, false, Command::kCompare, "K", "compare with a photograph; the next"},
    KeyBinding{GLFW_KEY_F, false, Command::kFrameAll, "F", "frame the whole scene"},
    KeyBinding{GLFW_KEY_F12, false, Command::kScreenshot, "F12", "screenshot: PNG and pose"},
    KeyBinding{GLFW_KEY_S, true, Command::kScreenshot, "Ctrl+S", "screenshot: PNG and pose"},
    KeyBinding{GLFW_KEY_R, false, Command::kRecordPath, "R", "record the path; again: write it"},
    KeyBinding{GLFW_KEY_P, false, Command::kReplayPath, "P", "replay the path that was recorded"},
    KeyBinding{GLFW_KEY_H, false, Command::kHelp, "H", "this help"},
    KeyBinding{GLFW_KEY_F1, false, Command::kHelp, "F1", "this help"},
    KeyBinding{GLFW_KEY_TAB, false, Command::kPanel, "Tab", "panel on or off"},
    KeyBinding{GLFW_KEY_F11, false, Command::kFullScreen, "F11", "full screen on or off"},
    KeyBinding{GLFW_KEY_V, false, Command::kVsync, "V", "wait for the display on or off"},
    KeyBinding{GLFW_KEY_ESCAPE, false, Command::kBack, "Esc",
               "close a list, help, full screen; or quit"},
    KeyBinding{GLFW_KEY_Q, true, Command::kQuit, "Ctrl+Q", "quit"},
};

/// That a command asks for.
std::optional<RenderMode> mode_of(Command command) {
    switch (command) {
        case Command::kLightField:
            return RenderMode::kLightField;
        case Command::kPerPixel:
            return RenderMode::kPerPixel;
        case Command::kAdaptive:
            return RenderMode::kAdaptive;
        case Command::kPaper2001:
            return RenderMode::kPaper2001;
        case Command::kHeigl:
            return RenderMode::kHeigl;
        default:
            return std::nullopt;
    }
}

/// The same.
std::optional<DebugPicture> picture_of(Command command) {
    switch (command) {
        case Command::kShowWeights:
            return DebugPicture::kWeights;
        case Command::kShowFaces:
            return DebugPicture::kFaces;
        case Command::kShowDepth:
            return DebugPicture::kDepth;
        case Command::kShowConfidence:
            return DebugPicture::kConfidence;
        case Command::kShowOcclusion:
            return DebugPicture::kOcclusion;
        case Command::kShowGrid:
            return DebugPicture::kGrid;
        default:
            return std::nullopt;
    }
}

void toggle(DebugPicture picture, RenderOptions& render) {
    render.debug_picture = render.debug_picture == picture ? DebugPicture::kNone : picture;
}

/// All that moves the eye at once goes through here: a path that is replayed would carry it away.
void stand(const Navigation& navigation, ViewerState& state) {
    state.navigation = navigation;
    state.replays_path = false;
    state.has_jumped = true;
}

/// The same, turning about the scene's centre from then on.
void stand_about_centre(const Eye& eye, const Lumigraph& lumigraph, ViewerState& state) {
    Navigation navigation = state.navigation;
    navigation.eye = eye;
    navigation.pivot_in_world = lumigraph.mesh.scene_centre_in_world;
    stand(navigation, state);
}

/// From where the eye stands, or else from the photograph nearest to it.
void go_to_neighbour(int step, const Lumigraph& lumigraph, ViewerState& state) {
    const int from = photograph_stood_at(lumigraph, state)
                         .value_or(nearest_view(lumigraph, state.navigation.eye));
    go_to_photograph(from + step, lumigraph, state);
}

/// Of all in their order, the first after the last.
template <class Value>
Value next_of(const std::vector<Value>& all, Value value) {
    const auto found = std::find(all.begin(), all.end(), value);
    return found == all.end() || found + 1 == all.end() ? all.front() : *(found + 1);
}

}  // namespace

std::span<const KeyBinding> key_bindings() { return kBindings; }

std::optional<Command> command_of(int key, bool with_control) {
    for (const KeyBinding& binding : kBindings) {
        if (binding.key == key && binding.with_control == with_control) return binding.command;
    }
    return std::nullopt;
}

ViewerState first_state(const Lumigraph& lumigraph, const RenderOptions& render) {
    ViewerState state;
    state.render = render;
    state.navigation.up_in_world = up_in_world(lumigraph);
    state.navigation.least_distance = least_distance(lumigraph);
    go_to_photograph(0, lumigraph, state);
    return state;
}

ViewerState state_after_opening(const Lumigraph& lumigraph, const ViewerState& state) {
    ViewerState after = first_state(lumigraph, state.render);
    static_cast<ViewerChoices&>(after) = state;
    after.planned = state.planned;
    after.package = state.package;
    return after;
}

void go_to_photograph(int view_index, const Lumigraph& lumigraph, ViewerState& state) {
    const int count = static_cast<int>(lumigraph.views.size());
    state.view_index = (view_index % count + count) % count;
    stand(snap_to(state.navigation, lumigraph, state.view_index), state);
}

void go_to_planned(int planned_index, const Lumigraph& lumigraph, ViewerState& state) {
    if (planned_index < 0 || planned_index >= static_cast<int>(state.planned.size())) return;
    state.planned_index = planned_index;
    stand_about_centre({state.navigation.eye.camera,
                        state.planned[static_cast<std::size_t>(planned_index)].cam_from_world},
                       lumigraph, state);
}

void go_to_eye(const Eye& eye, ViewerState& state) {
    stand(carried_to(state.navigation, eye), state);
}

void go_to_held_out(int index, const std::vector<HeldOutView>& held_out, const Lumigraph& lumigraph,
                    ViewerState& state) {
    if (index < 0 || index >= static_cast<int>(held_out.size())) return;
    state.compared_index = index;
    state.enlargement = {};
    stand_about_centre(held_out[static_cast<std::size_t>(index)].eye, lumigraph, state);
}

bool is_compared(const std::vector<HeldOutView>& held_out, const ViewerState& state) {
    const int index = state.compared_index;
    return index >= 0 && index < static_cast<int>(held_out.size()) &&
           is_same_eye(state.navigation.eye, held_out[static_cast<std::size_t>(index)].eye);
}

void compare_again_or_next(const std::vector<HeldOutView>& held_out, const Lumigraph& lumigraph,
                           ViewerState& state) {
    if (held_out.empty()) return;
    const int wished = std::max(0, state.compared_index + (is_compared(held_out, state) ? 1 : 0));
    go_to_held_out(wished % static_cast<int>(held_out.size()), held_out, lumigraph, state);
}

std::optional<int> photograph_stood_at(const Lumigraph& lumigraph, const ViewerState& state) {
    const LumigraphView& view = lumigraph.views[static_cast<std::size_t>(state.view_index)];
    if (!is_same_eye(state.navigation.eye, eye_at(view))) return std::nullopt;
    return state.view_index;
}

void apply(Command command, const Lumigraph& lumigraph, ViewerState& state) {
    RenderOptions& render = state.render;
    if (const auto mode = mode_of(command)) render.mode = *mode;
    if (const auto picture = picture_of(command)) toggle(*picture, render);
    switch (command) {
        case Command::kNextMode:
            render.mode = next_of(all_render_modes(), render.mode);
            break;
        case Command::kNextPicture:
            render.debug_picture = next_of(all_debug_pictures(), render.debug_picture);
            break;
        case Command::kOcclusion:
            render.correct_occlusion = !render.correct_occlusion;
            break;
        case Command::kPreviousPhotograph:
            go_to_neighbour(-1, lumigraph, state);
            break;
        case Command::kNextPhotograph:
            go_to_neighbour(1, lumigraph, state);
            break;
        case Command::kNearestPhotograph:
            go_to_photograph(nearest_view(lumigraph, state.navigation.eye), lumigraph, state);
            break;
        case Command::kFrameAll:
            stand(frame_all(state.navigation, bounds_of(lumigraph)), state);
            break;
        case Command::kCompare:
            state.wants_comparison = true;
            break;
        case Command::kScreenshot:
            state.wants_screenshot = true;
            break;
        case Command::kRecordPath:
            state.records_path = !state.records_path;
            break;
        case Command::kReplayPath:
            state.replays_path = !state.replays_path && state.has_path;
            break;
        case Command::kHelp:
            state.shows_help = !state.shows_help;
            break;
        case Command::kPanel:
            state.shows_panel = !state.shows_panel;
            break;
        case Command::kFullScreen:
            state.fills_screen = !state.fills_screen;
            break;
        case Command::kVsync:
            state.waits_for_vsync = !state.waits_for_vsync;
            break;
        case Command::kBack:
            if (std::exchange(state.shows_help, false)) break;
            if (!std::exchange(state.fills_screen, false)) state.wants_to_close = true;
            break;
        case Command::kQuit:
            state.wants_to_close = true;
            break;
        // These are the modes' and the pictures', above.
        case Command::kLightField:
        case Command::kPerPixel:
        case Command::kAdaptive:
        case Command::kPaper2001:
        case Command::kHeigl:
        case Command::kShowWeights:
        case Command::kShowFaces:
        case Command::kShowDepth:
        case Command::kShowConfidence:
        case Command::kShowOcclusion:
        case Command::kShowGrid:
            break;
    }
}

}  // namespace lumi
