#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/viewer/commands.h"
#include "render/viewer/comparison.h"
#include "render/viewer/frame_statistics.h"
#include "render/viewer/glfw_window.h"

namespace lumi {

/// Dear ImGui over the picture: the panel with modes and figures, a line with the last message at
/// the bottom, and the list of keys. Needs the window's context.
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
    /// Whether a list is open, so that Esc closes that.
    [[nodiscard]] bool has_open_list() const;
    /// Whether a text is being typed into a panel.
    [[nodiscard]] bool takes_keys() const;

 private:
    std::string message_;           ///< That was shown last.
    double message_began_s_ = 0.0;  ///< By ImGui's clock.
};

}  // namespace lumi
