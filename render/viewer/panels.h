#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "render/viewer/commands.h"
#include "render/viewer/comparison.h"
#include "render/viewer/frame_statistics.h"
#include "render/viewer/glfw_window.h"
#include "render/viewer/key_places.h"
#include "render/viewer/panel_place.h"

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
    /// Whether the mouse is over a panel, so that the picture must not take its drags: as panels
    /// were drawn last, and where nothing is said of a place (in pixels), as ImGui last saw it.
    [[nodiscard]] bool takes_mouse(const std::optional<Eigen::Vector2d>& at_px) const;
    /// Whether a list is open, so that Esc closes that.
    [[nodiscard]] bool has_open_list() const;
    /// Whether a text is being typed into a panel.
    [[nodiscard]] bool takes_keys() const;

 private:
    /// Whether the last message is still told: some seconds, and what failed until somebody does
    /// something.
    bool is_news(const FrameStatistics& statistics);
    void show_help(bool& open);

    std::vector<std::array<std::string, 2>> help_rows_;  ///< While the help is shown.
    int messages_ = 0;                                   ///< That were seen.
    double message_began_s_ = 0.0;                       ///< By ImGui's clock.
    bool is_over_ = false;                               ///< The message was seen long enough.
    std::vector<PanelPlace> places_;                     ///< That take the mouse.
};

}  // namespace lumi
