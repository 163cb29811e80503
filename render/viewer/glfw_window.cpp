#include "render/viewer/glfw_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "render/viewer/input_events.h"
#include "render/viewer/key_places.h"

namespace lumi {

/// Where a window lies on the screens.
struct WindowPlace {
    Eigen::Vector2i at = Eigen::Vector2i::Zero();
    Eigen::Vector2i size = Eigen::Vector2i::Zero();
};

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

/// Pixels of the framebuffer for each of the window system's units.
Eigen::Vector2d px_per_unit(GLFWwindow* window) {
    Eigen::Vector2i window_size;
    Eigen::Vector2i framebuffer_size;
    glfwGetWindowSize(window, &window_size.x(), &window_size.y());
    glfwGetFramebufferSize(window, &framebuffer_size.x(), &framebuffer_size.y());
    if (window_size.minCoeff() <= 0 || framebuffer_size.minCoeff() <= 0)
        return Eigen::Vector2d::Ones();
    return framebuffer_size.cast<double>().cwiseQuotient(window_size.cast<double>());
}

Eigen::Vector2d cursor_px(GLFWwindow* window) {
    Eigen::Vector2d cursor;
    glfwGetCursorPos(window, &cursor.x(), &cursor.y());
    return cursor.cwiseProduct(px_per_unit(window));
}

/// The first of all screens where none shows the window's middle.
GLFWmonitor* monitor_showing(const WindowPlace& window) {
    int count = 0;
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    const Eigen::Vector2i middle = window.at + window.size / 2;
    for (int i = 0; i < count; ++i) {
        const GLFWvidmode* const mode = glfwGetVideoMode(monitors[i]);
        Eigen::Vector2i at;
        glfwGetMonitorPos(monitors[i], &at.x(), &at.y());
        if (mode == nullptr) continue;
        const Eigen::Vector2i inside = middle - at;
        if (inside.minCoeff() >= 0 && inside.x() < mode->width && inside.y() < mode->height)
            return monitors[i];
    }
    return glfwGetPrimaryMonitor();
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

    static InputEvents& events_of(GLFWwindow* window) {
        return static_cast<Implementation*>(glfwGetWindowUserPointer(window))->events;
    }
    void listen();

    GlfwLibrary library;
    GLFWwindow* window;
    InputEvents events{cursor_px(window)};  ///< Collected by callbacks until they are polled.
    WindowPlace before_filling;             ///< While the window fills the screen.
};

/// GLFW calls back in the order in which things happened, however late it is asked.
void GlfwWindow::Implementation::listen() {
    glfwSetWindowUserPointer(window, this);
    glfwSetCursorPosCallback(window, [](GLFWwindow* source, double x, double y) {
        events_of(source).cursor_moved_to(Eigen::Vector2d(x, y).cwiseProduct(px_per_unit(source)));
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* source, int button, int action, int) {
        events_of(source).button_changed(button, action == GLFW_PRESS, glfwGetTime());
    });
    glfwSetScrollCallback(window, [](GLFWwindow* source, double, double steps) {
        events_of(source).wheel_turned(steps);
    });
    glfwSetKeyCallback(window, [](GLFWwindow* source, int key, int, int action, int modifiers) {
        if (action == GLFW_REPEAT) return;
        events_of(source).key_changed(key, action == GLFW_PRESS);
        if (action != GLFW_PRESS) return;
        const bool with_control = (modifiers & GLFW_MOD_CONTROL) != 0;
        const auto command = command_of(key_meant(key, with_control, label_of_key), with_control);
        if (command) events_of(source).asked_for(*command);
    });
    glfwSetDropCallback(window, [](GLFWwindow* source, int count, const char** paths) {
        for (int i = 0; i < count; ++i) events_of(source).dropped(paths[i]);
    });
}

GlfwWindow::GlfwWindow(int width_px, int height_px, const std::string& title, bool visible)
    : implementation_(std::make_unique<Implementation>(width_px, height_px, title, visible)) {
    glfwMakeContextCurrent(handle());
    implementation_->listen();
}

GlfwWindow::~GlfwWindow() = default;

WindowInput GlfwWindow::poll(double timeout_s) {
    if (timeout_s > 0 && !implementation_->events.has_more()) {
        glfwWaitEventsTimeout(timeout_s);
    } else {
        glfwPollEvents();
    }
    return implementation_->events.taken();
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

void GlfwWindow::fill_screen(bool fill) {
    GLFWwindow* const window = handle();
    if (fill == (glfwGetWindowMonitor(window) != nullptr)) return;
    WindowPlace& place = implementation_->before_filling;
    if (!fill) {
        glfwSetWindowMonitor(window, nullptr, place.at.x(), place.at.y(), place.size.x(),
                             place.size.y(), GLFW_DONT_CARE);
        return;
    }
    glfwGetWindowPos(window, &place.at.x(), &place.at.y());
    glfwGetWindowSize(window, &place.size.x(), &place.size.y());
    GLFWmonitor* const monitor = monitor_showing(place);
    const GLFWvidmode* const mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (mode == nullptr) return;
    glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

float GlfwWindow::content_scale() const {
    Eigen::Vector2f scale;
    glfwGetWindowContentScale(handle(), &scale.x(), &scale.y());
    // Some window systems scale their units themselves.
    const float of_units = scale.y() / static_cast<float>(px_per_unit(handle()).y());
    // Of a screen that tells its size in millimetres, letters are no crisper for a few per cent.
    constexpr float kStepsOfOne = 4;
    return std::max(1.0F, std::round(kStepsOfOne * of_units) / kStepsOfOne);
}

void GlfwWindow::enlarge(float times) {
    WindowPlace place;
    glfwGetWindowPos(handle(), &place.at.x(), &place.at.y());
    glfwGetWindowSize(handle(), &place.size.x(), &place.size.y());
    GLFWmonitor* const monitor = monitor_showing(place);
    if (monitor == nullptr || place.size.minCoeff() <= 0) return;
    Eigen::Vector2i room_at;
    Eigen::Vector2i room;
    glfwGetMonitorWorkarea(monitor, &room_at.x(), &room_at.y(), &room.x(), &room.y());
    const float fitting = room.cast<float>().cwiseQuotient(place.size.cast<float>()).minCoeff();
    const float enlarged = std::min(times, fitting);
    if (enlarged <= 1) return;
    const Eigen::Vector2i size =
        (enlarged * place.size.cast<float>()).array().floor().matrix().cast<int>();
    glfwSetWindowSize(handle(), size.x(), size.y());
}

GLFWwindow* GlfwWindow::handle() const { return implementation_->window; }

std::string label_of_key(int key) {
    const char* const label = glfwGetKeyName(key, 0);
    return label == nullptr ? std::string() : std::string(label);
}

}  // namespace lumi
