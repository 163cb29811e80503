#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/lumigraph/package.h"
#include "render/viewer/controls.h"
#include "render/viewer/enlargement.h"

namespace lumi {

/// What a key asks for.
enum class Command {
    kLightField,
    kPerPixel,
    kAdaptive,
    kPaper2001,
    kHeigl,
    kNextMode,
    kShowWeights,
    kShowFaces,
    kShowDepth,
    kShowConfidence,
    kShowOcclusion,
    kShowGrid,
    kNextPicture,
    kOcclusion,
    kPreviousPhotograph,
    kNextPhotograph,
    kNearestPhotograph,
    kCompare,
    kFrameAll,
    kScreenshot,
    kRecordPath,
    kReplayPath,
    kHelp,
    kPanel,
    kFullScreen,
    kVsync,
    kBack,
    kQuit,
};

/// A key (GLFW's code) and what it does; which key of a user's keyboard that is, key_places.h says.
/// W A S D Q E fly without Ctrl.
struct KeyBinding {
    int key;
    bool with_control;
    Command command;
    const char* shown;  ///< "Ctrl+D"
    const char* help;
};
[[nodiscard]] std::span<const KeyBinding> key_bindings();
[[nodiscard]] std::optional<Command> command_of(int key, bool with_control);

/// Where the next photograph would help, and how to get there in words.
struct PlannedView {
    Rigid3 cam_from_world;
    std::string words;
};

/// A photograph that the Lumigraph was made without, and the eye that took it, both upright
/// (photograph_eye.h).
struct HeldOutView {
    std::string name;
    Eye eye;
    ColorImage photograph;  ///< Of the size of the eye's camera.
};

/// Says how alike a frame of the eye of a held-out photograph is to that, in figures.
using LikenessWords = std::function<std::string(const Frame& drawn, const HeldOutView& view)>;

/// What is chosen of pictures and panels, whichever package is shown.
struct ViewerChoices {
    RenderOptions render;
    /// Kept while the eye moves by coarser frames and, by `adaptive`, with fewer triangles; 0: by
    /// coarser frames alone, as many as MovingResolution keeps by itself.
    double frames_per_second = 0.0;
    bool shows_help = false;
    bool shows_panel = true;
    bool fills_screen = false;
    bool waits_for_vsync = true;
    Exposures exposures = Exposures::kEvened;  ///< The package is read again where they change.
};

/// All that keys and panels change.
struct ViewerState : ViewerChoices {
    Navigation navigation;
    std::vector<PlannedView> planned;  ///< The most helpful first; may be empty.
    int planned_index = -1;            ///< The one that was last stood at, -1: none yet.
    int view_index = 0;                ///< The photograph that was last gone to.
    int compared_index = -1;           ///< The held-out photograph that is compared with; -1: none.
    double compared_share = 0.5;    ///< So much of the picture shows the photograph, from the left.
    bool shows_difference = false;  ///< Instead of the photograph.
    Enlargement enlargement;        ///< Of drawing and photograph, while they are compared.
    bool wants_comparison = false;  ///< With the held-out photograph again, or with the next.
    bool wants_screenshot = false;
    bool records_path = false;
    bool has_path = false;            ///< There is one to replay.
    bool has_unwritten_path = false;  ///< That could not be written.
    bool writes_path_again = false;   ///< It is wished.
    bool replays_path = false;        ///< Until its end, or until the eye is moved otherwise.
    bool has_jumped = false;  ///< To another place, instead of moving there; until it is recorded.
    bool wants_to_close = false;
    std::filesystem::path package;  ///< Where it was read; empty: it cannot be read again.
    std::vector<std::filesystem::path> recent_packages;  ///< That can be opened; may be empty.
    std::filesystem::path package_to_open;               ///< Empty: the one that is shown stays.
};

/// At the first photograph.
[[nodiscard]] ViewerState first_state(const Lumigraph& lumigraph, const RenderOptions& render);

/// At the first photograph of a Lumigraph that was opened in place of another: what was chosen of
/// pictures and panels stays, and what the state tells of the package.
[[nodiscard]] ViewerState state_after_opening(const Lumigraph& lumigraph, const ViewerState& state);

/// Carries out a command. A debug picture that is shown already is put away.
void apply(Command command, const Lumigraph& lumigraph, ViewerState& state);

/// Stands where a photograph is planned and turns about the scene's centre; an index that does not
/// exist does nothing.
void go_to_planned(int planned_index, const Lumigraph& lumigraph, ViewerState& state);

/// Stands where another eye does and turns about what is straight ahead of it.
void go_to_eye(const Eye& eye, ViewerState& state);

/// Stands where a held-out photograph was taken, to compare with it.
void go_to_held_out(int index, const std::vector<HeldOutView>& held_out, const Lumigraph& lumigraph,
                    ViewerState& state);

/// Whether the eye stands where the held-out photograph was taken that it is compared with.
[[nodiscard]] bool is_compared(const std::vector<HeldOutView>& held_out, const ViewerState& state);

/// Goes back to the held-out photograph that was compared with last; from there to the next one.
/// Without any does nothing.
void compare_again_or_next(const std::vector<HeldOutView>& held_out, const Lumigraph& lumigraph,
                           ViewerState& state);

/// The photograph at whose place the eye stands, to the last bit.
[[nodiscard]] std::optional<int> photograph_stood_at(const Lumigraph& lumigraph,
                                                     const ViewerState& state);

/// Stands at a photograph; indices wrap around.
void go_to_photograph(int view_index, const Lumigraph& lumigraph, ViewerState& state);

}  // namespace lumi
