#include "render/viewer/glfw_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

#include "calib/work/error.h"
#include "calib/work/printable.h"

namespace lumi {
namespace {

Error no_window(const std::string& what, const std::string& advice) {
    const char* description = nullptr;
    glfwGetError(&description);
    const std::string reason = description == nullptr ? "no reason given" : description;
    return {ErrorKind::kResources, "E-GL-CONTEXT", what + ": " + printable(reason), advice};
}

GLFWwindow* create_window(int width_px, int height_px, const std::string& title, bool visible) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_SAMPLES, 0);
    GLFWwindow* window =
        glfwCreateWindow(width_px, height_px, printable(title).c_str(), nullptr, nullptr);
    if (window == nullptr)
        throw no_window("no window with OpenGL 3.3 core can be opened",
                        "where the display has no OpenGL 3.3, set LIBGL_ALWAYS_SOFTWARE=1, or draw "
                        "frames to files instead: `lumi render`");
    return window;
}

bool is_held(GLFWwindow* window, int key) { return glfwGetKey(window, key) == GLFW_PRESS; }

double axis(GLFWwindow* window, int negative_key, int positive_key) {
    return (is_held(window, positive_key) ? 1.0 : 0.0) -
           (is_held(window, negative_key) ? 1.0 : 0.0);
}

}  // namespace

/// GLFW itself, for as long as there is a window.
class GlfwLibrary {
 public:
    GlfwLibrary() {
        if (glfwInit() != GLFW_TRUE)
            throw no_window("no window can be opened",
                            "without a display, draw frames to files instead: `lumi render`");
    }
    ~GlfwLibrary() { glfwTerminate(); }
    GlfwLibrary(const GlfwLibrary&) = delete;
    GlfwLibrary& operator=(const GlfwLibrary&) = delete;
};

struct GlfwWindow::Implementation {
    Implementation(int width_px, int height_px, const std::string& title, bool visible)
        : window(create_window(width_px, height_px, title, visible)) {}
    ~Implementation() { glfwDestroyWindow(window); }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;

    static WindowInput& input_of(GLFWwindow* window) {
        return static_cast<Implementation*>(glfwGetWindowUserPointer(window))->input;
    }
    void listen();
    /// The way of the cursor since the last call, in pixels of the framebuffer.
    Eigen::Vector2d cursor_way_px();

    GlfwLibrary library;
    GLFWwindow* window;
    WindowInput input;  ///< Collected by callbacks until it is polled.
    Eigen::Vector2d cursor = Eigen::Vector2d::Zero();
};

void GlfwWindow::Implementation::listen() {
    glfwSetWindowUserPointer(window, this);
    glfwGetCursorPos(window, &cursor.x(), &cursor.y());
    glfwSetScrollCallback(window, [](GLFWwindow* source, double, double steps) {
        input_of(source).wheel_steps += steps;
    });
    glfwSetKeyCallback(window, [](GLFWwindow* source, int key, int, int action, int modifiers) {
        if (action != GLFW_PRESS) return;
        const auto command = command_of(key, (modifiers & GLFW_MOD_CONTROL) != 0);
        if (command) input_of(source).commands.push_back(*command);
    });
    glfwSetDropCallback(window, [](GLFWwindow* source, int count, const char** paths) {
        for (int i = 0; i < count; ++i) input_of(source).dropped.emplace_back(paths[i]);
    });
}

Eigen::Vector2d GlfwWindow::Implementation::cursor_way_px() {
    Eigen::Vector2d now;
    glfwGetCursorPos(window, &now.x(), &now.y());
    Eigen::Vector2i window_size;
    Eigen::Vector2i framebuffer_size;
    glfwGetWindowSize(window, &window_size.x(), &window_size.y());
    glfwGetFramebufferSize(window, &framebuffer_size.x(), &framebuffer_size.y());
    const Eigen::Vector2d way = now - cursor;
    cursor = now;
    if (window_size.minCoeff() <= 0) return Eigen::Vector2d::Zero();
    return way.cwiseProduct(
        framebuffer_size.cast<double>().cwiseQuotient(window_size.cast<double>()));
}

GlfwWindow::GlfwWindow(int width_px, int height_px, const std::string& title, bool visible)
    : implementation_(std::make_unique<Implementation>(width_px, height_px, title, visible)) {
    glfwMakeContextCurrent(handle());
    implementation_->listen();
}

GlfwWindow::~GlfwWindow() = default;

WindowInput GlfwWindow::poll(double timeout_s) {
    if (timeout_s > 0) {
        glfwWaitEventsTimeout(timeout_s);
    } else {
        glfwPollEvents();
    }
    GLFWwindow* window = handle();
    const auto button = [&](int which) { return glfwGetMouseButton(window, which) == GLFW_PRESS; };
    WindowInput input = std::exchange(implementation_->input, {});
    input.drag_px = implementation_->cursor_way_px();
    input.left_button = button(GLFW_MOUSE_BUTTON_LEFT);
    input.middle_button = button(GLFW_MOUSE_BUTTON_MIDDLE);
    input.right_button = button(GLFW_MOUSE_BUTTON_RIGHT);
    input.shift = is_held(window, GLFW_KEY_LEFT_SHIFT) || is_held(window, GLFW_KEY_RIGHT_SHIFT);
    input.control =
        is_held(window, GLFW_KEY_LEFT_CONTROL) || is_held(window, GLFW_KEY_RIGHT_CONTROL);
    input.flight = {axis(window, GLFW_KEY_A, GLFW_KEY_D), axis(window, GLFW_KEY_E, GLFW_KEY_Q),
                    axis(window, GLFW_KEY_S, GLFW_KEY_W)};
    return input;
}

void GlfwWindow::show_frame() { glfwSwapBuffers(handle()); }

Eigen::Vector2i GlfwWindow::framebuffer_size_px() const {
    Eigen::Vector2i size;
    glfwGetFramebufferSize(handle(), &size.x(), &size.y());
    return size;
}

bool GlfwWindow::should_close() const { return glfwWindowShouldClose(handle()) != 0; }

void GlfwWindow::set_title(const std::string& title) {
    glfwSetWindowTitle(handle(), printable(title).c_str());
}

void GlfwWindow::wait_for_vsync(bool wait) { glfwSwapInterval(wait ? 1 : 0); }

GLFWwindow* GlfwWindow::handle() const { return implementation_->window; }

}  // namespace lumi
