#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "render/frame/frame.h"
#include "render/paths/timed_path.h"
#include "render/viewer/commands.h"
#include "render/viewer/frame_statistics.h"
#include "render/viewer/opened_package.h"

namespace lumi {

struct WindowInput;

/// Reads what a window wrote: the eye of a screenshot, alone, or those of a path. Throws Error.
using EyesReader = std::function<std::vector<TimedEye>(const std::filesystem::path&)>;

/// How the window begins, and whether it stays.
struct WindowOptions {
    int width_px = 0;  ///< 0: by the photograph it begins at (window_size.h).
    int height_px = 0;
    std::string view_name;           ///< The photograph it begins at; empty: the first.
    RenderOptions render;            ///< But for fading, which OpenedPackage says.
    double frames_per_second = 0.0;  ///< As in ViewerState.
    int planned_index = -1;          ///< The plan's one it begins at; -1: at the photograph.
    /// Reads what is opened besides, and again.
    PackageLoader load = opened_alone;
    /// Reads eyes from files that are dropped on the window; empty: they are taken for packages.
    EyesReader read_eyes{};
    /// Where it stands first in place of a photograph: one, or a path that is replayed.
    std::vector<TimedEye> eyes{};
    /// How the photographs were read.
    Exposures exposures = Exposures::kEvened;
    /// Where the Lumigraph was read, and the list that packages which are opened are kept in
    /// (recent_packages.h); empty: it cannot be read again, and they are not kept.
    std::filesystem::path package;
    std::filesystem::path recent_file;
    /// Where it is interrupted, the window is closed; told of what a window that fails cannot show.
    Progress* progress = nullptr;
    /// Not empty: one frame is drawn, without panels, and written here as PNG with its pose as JSON
    /// beside it; nobody sees a window.
    std::filesystem::path screenshot_path;
};

/// A window onto a package. Draws with the same LumigraphRenderer as files are drawn with;
/// coarser while the eye moves where the machine is slow, whole at rest.
///
/// Throws Error: E-GL-CONTEXT (no display, or no OpenGL 3.3), E-GL-LIMIT, E-VIEW-NAME.
class ViewerWindow {
 public:
    ViewerWindow(OpenedPackage opened, const WindowOptions& options);
    ~ViewerWindow();
    ViewerWindow(const ViewerWindow&) = delete;
    ViewerWindow& operator=(const ViewerWindow&) = delete;

    /// Takes in what the user did, or what is said here in its place, and shows a frame. False when
    /// the window was closed. Where it throws, a path that is recorded is written first,
    /// and where to is noted.
    bool step(const WindowInput* in_place_of_user = nullptr);
    /// Draws the whole picture of the present eye and writes it with its pose.
    void write_screenshot_to(const std::filesystem::path& path);
    /// Opens another package (package_meant_by) in place of this one; one that cannot be read
    /// leaves this one and a message in the panel.
    void open_package(const std::filesystem::path& folder);
    /// Stands at a photograph of the package that is shown; indices wrap around.
    void go_to_photograph(int view_index);

    [[nodiscard]] ViewerState& state();
    [[nodiscard]] const FrameStatistics& statistics() const;
    /// What the package that is shown can be compared with.
    [[nodiscard]] const std::vector<HeldOutView>& held_out() const;

 private:
    struct Implementation;
    bool step_unguarded(const WindowInput* in_place_of_user);
    std::unique_ptr<Implementation> implementation_;
};

/// Shows the package until the user closes the window; or, with a screenshot path, writes one
/// frame and returns. Throws what ViewerWindow throws, and E-FILE-WRITE.
void run_window(OpenedPackage opened, const WindowOptions& options);

}  // namespace lumi
