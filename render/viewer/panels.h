#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "render/viewer/commands.h"
#include "render/viewer/comparison.h"
#include "render/viewer/glfw_window.h"

namespace lumi {

/// What the panel tells of the last frame.
struct FrameStatistics {
    double frame_ms = 0.0;
    int width_px = 0;
    int height_px = 0;
    std::size_t triangles = 0;
    std::vector<float> recent_frames_ms;  ///< The oldest first.
    std::string gl_description;
    std::string message;  ///< The last thing that happened, or failed.
};

/// Dear ImGui over the picture: the panel with modes and figures, and the list of keys. Needs the
/// window's context.
class Panels {
 public:
    explicit Panels(const GlfwWindow& window);
    ~Panels();
    Panels(const Panels&) = delete;
    Panels& operator=(const Panels&) = delete;

    /// Draws over the bound framebuffer, the overlay first; a click may change the state.
    void draw(const Lumigraph& lumigraph, const std::vector<HeldOutView>& held_out,
              const std::optional<PictureOverlay>& overlay, const FrameStatistics& statistics,
              ViewerState& state);
    /// Whether the mouse is over a panel, so that the picture must not take its drags.
    [[nodiscard]] bool takes_mouse() const;
    /// Whether a text is being typed into a panel.
    [[nodiscard]] bool takes_keys() const;
};

}  // namespace lumi
