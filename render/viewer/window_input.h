#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <vector>

#include "render/viewer/commands.h"

namespace lumi {

/// What the user did since the last frame. Places in framebuffer pixels.
struct WindowInput {
    /// Way of the cursor while the buttons were held.
    Eigen::Vector2d drag_px = Eigen::Vector2d::Zero();
    bool left_button = false;  ///< Was held, be it shortly.
    bool middle_button = false;
    bool right_button = false;
    bool shift = false;
    bool control = false;
    double wheel_steps = 0.0;
    Eigen::Vector3d flight = Eigen::Vector3d::Zero();  ///< Held keys: -1, 0, 1 along each eye axis.
    std::optional<Eigen::Vector2d> cursor_px{};
    std::optional<Eigen::Vector2d> pressed_at_px{};  ///< Where a button was pressed, if one was.
    std::optional<Eigen::Vector2d> double_clicked_at_px{};
    std::vector<Command> commands;
    std::vector<std::filesystem::path> dropped;
};

/// Moves the eye as the input asks: left drag orbits, right or middle or Shift+left drag pans,
/// Ctrl+left drag looks around, the wheel zooms, held keys fly (Shift: fast). `seconds` is the time
/// since the last frame, the size is that of the window's picture. True when the eye moved.
bool steer(const WindowInput& input, double seconds, int width_px, int height_px,
           Navigation& navigation);

/// Enlarges, about the cursor, where the wheel would move the eye away from what there is to
/// compare; takes the wheel's steps out of the input. True when it did.
bool enlarge(WindowInput& input, const Eigen::Vector2i& size_px, Enlargement& enlargement);

/// Turns about what is shown at a place of the window's picture of this size from then on.
void turn_about(const Eigen::Vector2d& place_px, const Eigen::Vector2i& size_px,
                const Lumigraph& lumigraph, Navigation& navigation);

}  // namespace lumi
