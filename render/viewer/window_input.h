#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "render/viewer/commands.h"

namespace lumi {

/// What the user did since the last frame.
struct WindowInput {
    Eigen::Vector2d drag_px = Eigen::Vector2d::Zero();  ///< Way of the cursor, framebuffer pixels.
    bool left_button = false;
    bool middle_button = false;
    bool right_button = false;
    bool shift = false;
    bool control = false;
    double wheel_steps = 0.0;
    Eigen::Vector3d flight = Eigen::Vector3d::Zero();  ///< Held keys: -1, 0, 1 along each eye axis.
    std::vector<Command> commands;
    std::vector<std::filesystem::path> dropped;
};

/// Moves the eye as the input asks: left drag orbits, right or middle or Shift+left drag pans,
/// Ctrl+left drag looks around, the wheel zooms, held keys fly (Shift: fast). `seconds` is the time
/// since the last frame, the size is that of the window's picture. True when the eye moved.
bool steer(const WindowInput& input, double seconds, int width_px, int height_px,
           Navigation& navigation);

}  // namespace lumi
