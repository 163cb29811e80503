#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/viewer/commands.h"
#include "render/viewer/panels.h"

namespace lumi {

struct WindowInput;

/// How the window begins, and whether it stays.
struct WindowOptions {
    int width_px = 0;  ///< 0: the size of the photograph it begins at.
    int height_px = 0;
    std::string view_name;  ///< The photograph it begins at; empty: the first.
    RenderOptions render;
    double frames_per_second = 0.0;     ///< As in ViewerState.
    std::vector<PlannedView> planned;   ///< Offered in the panel.
    std::vector<HeldOutView> held_out;  ///< To be compared with; offered in the panel.
    int planned_index = -1;             ///< The one it begins at; -1: at the photograph.
    /// Where the Lumigraph was read, and the list that packages which are opened are kept in
    /// (recent_packages.h); empty: they are not kept.
    std::filesystem::path package;
    std::filesystem::path recent_file;
    const Progress* progress = nullptr;  ///< Where it is interrupted, the window is closed.
    /// Not empty: one frame is drawn, without panels, and written here as PNG with its pose as JSON
    /// beside it; nobody sees a window.
    std::filesystem::path screenshot_path;
};

/// A window onto a Lumigraph. Draws with the same LumigraphRenderer as files are drawn with;
/// coarser while the eye moves where the machine is slow, whole at rest.
///
/// Throws Error: E-GL-CONTEXT (no display, or no OpenGL 3.3), E-GL-LIMIT, E-VIEW-NAME.
class ViewerWindow {
 public:
    ViewerWindow(Lumigraph lumigraph, const WindowOptions& options);
    ~ViewerWindow();
    ViewerWindow(const ViewerWindow&) = delete;
    ViewerWindow& operator=(const ViewerWindow&) = delete;

    /// Takes in what the user did, or what is said here in its place, and shows a frame. False when
    /// the window was closed.
    bool step(const WindowInput* in_place_of_user = nullptr);
    /// Draws the whole picture of the present eye and writes it with its pose.
    void write_screenshot_to(const std::filesystem::path& path);
    /// Opens another package in place of this one; one that cannot be read leaves this one and a
    /// message in the panel.
    void open_package(const std::filesystem::path& folder);

    [[nodiscard]] ViewerState& state();
    [[nodiscard]] const FrameStatistics& statistics() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Shows the Lumigraph until the user closes the window; or, with a screenshot path, writes one
/// frame and returns. Throws what ViewerWindow throws, and E-FILE-WRITE.
void run_window(Lumigraph lumigraph, const WindowOptions& options);

}  // namespace lumi
