#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include "render/viewer/window_input.h"

struct GLFWwindow;

namespace lumi {

/// A window with an OpenGL 3.3 core context, which is current from its construction on. One at a
/// time, on the main thread.
class GlfwWindow {
 public:
    /// Throws Error (E-GL-CONTEXT) when there is no display or no such context, with `lumi render`
    /// as the way out.
    GlfwWindow(int width_px, int height_px, const std::string& title, bool visible);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    /// What happened since the last call; waits up to `timeout_s` for something to happen.
    [[nodiscard]] WindowInput poll(double timeout_s);
    void show_frame();  ///< Swaps the buffers.

    [[nodiscard]] Eigen::Vector2i framebuffer_size_px() const;
    [[nodiscard]] bool should_close() const;
    void set_title(const std::string& title);
    void wait_for_vsync(bool wait);
    [[nodiscard]] GLFWwindow* handle() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace lumi
