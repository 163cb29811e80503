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

    /// What happened since the last call, one gesture after the other (InputEvents::taken); waits
    /// up to `timeout_s` for something to happen.
    [[nodiscard]] WindowInput poll(double timeout_s);
    void show_frame();  ///< Swaps the buffers.

    [[nodiscard]] Eigen::Vector2i framebuffer_size_px() const;
    [[nodiscard]] bool should_close() const;
    void set_title(const std::string& title);
    void wait_for_vsync(bool wait);
    /// Over the whole screen on which its middle lies, or as it was before.
    void fill_screen(bool fill);
    /// How large letters are to be, in the window system's units, as a multiple of their size on an
    /// ordinary screen.
    [[nodiscard]] float content_scale() const;
    /// As far as the screen has room.
    void enlarge(float times);
    [[nodiscard]] GLFWwindow* handle() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// What is written on a key (GLFW's code) of the user's keyboard, without Shift; empty where
/// nothing is, or nothing that prints. While there is a window.
[[nodiscard]] std::string label_of_key(int key);

}  // namespace lumi
