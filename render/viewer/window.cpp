#include "render/viewer/window.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "calib/work/error.h"
#include "calib/work/process_memory.h"
#include "render/gl/capabilities.h"
#include "render/lumigraph/package.h"
#include "render/lumigraph/same_eye.h"
#include "render/renderer/frame_target.h"
#include "render/subdivision/triangle_budget.h"
#include "render/viewer/glfw_window.h"
#include "render/viewer/moving_resolution.h"
#include "render/viewer/path_recording.h"
#include "render/viewer/photograph_eye.h"
#include "render/viewer/recent_packages.h"
#include "render/viewer/screenshot.h"

namespace lumi {

/// All that a drawn frame depends on.
struct DrawnFrame {
    Eye eye;
    RenderOptions options;
    double scale = 0.0;
};

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// How long the eye must rest before the whole picture is drawn.
constexpr double kRestBeforeWhole_s = 0.15;
constexpr double kIdleWait_s = 0.1;

bool same(const DrawnFrame& a, const DrawnFrame& b) {
    return is_same_eye(a.eye, b.eye) && a.scale == b.scale && a.options.mode == b.options.mode &&
           a.options.debug_picture == b.options.debug_picture &&
           a.options.correct_occlusion == b.options.correct_occlusion &&
           a.options.fade_beyond_capture == b.options.fade_beyond_capture &&
           a.options.guess_surroundings == b.options.guess_surroundings &&
           a.options.smooth_silhouettes == b.options.smooth_silhouettes &&
           a.options.triangle_error_ratio == b.options.triangle_error_ratio;
}

ViewerState beginning(const Lumigraph& lumigraph, const WindowOptions& options) {
    ViewerState state = first_state(lumigraph, options.render);
    if (!options.view_name.empty()) {
        go_to_photograph(index_of_view(lumigraph, options.view_name), lumigraph, state);
    }
    state.frames_per_second = options.frames_per_second;
    state.planned = options.planned;
    go_to_planned(options.planned_index, lumigraph, state);
    return state;
}

/// A window's size that keeps the picture's shape and fits on an ordinary screen.
Eigen::Vector2i window_size(const WindowOptions& options, const Camera& camera) {
    if (options.width_px > 0 && options.height_px > 0) {
        return {options.width_px, options.height_px};
    }
    const Eigen::Vector2d picture(camera.width_px, camera.height_px);
    if (!options.screenshot_path.empty()) return picture.cast<int>();
    constexpr double kMaxWidth_px = 1600;
    constexpr double kMaxHeight_px = 900;
    const double scale = std::min({1.0, kMaxWidth_px / picture.x(), kMaxHeight_px / picture.y()});
    return (scale * picture).array().round().matrix().cast<int>().cwiseMax(1);
}

void remember_frame_time(FrameStatistics& statistics) {
    constexpr std::size_t kRemembered = 120;
    std::vector<float>& recent = statistics.recent_frames_ms;
    if (recent.size() == kRemembered) recent.erase(recent.begin());
    recent.push_back(static_cast<float>(statistics.frame_ms));
}

std::string title_of(const Lumigraph& lumigraph) { return "lumi - " + lumigraph.name; }

}  // namespace

struct ViewerWindow::Implementation {
    Implementation(Lumigraph shown, const WindowOptions& options)
        : lumigraph(std::move(shown)),
          state(beginning(lumigraph, options)),
          size_px(window_size(options, state.navigation.eye.camera)),
          window(size_px.x(), size_px.y(), title_of(lumigraph), options.screenshot_path.empty()),
          panels(window),
          renderer(lumigraph),
          comparison(options.held_out),
          recent_file(options.recent_file) {
        statistics.gl_description = query_capabilities().description;
        remember(options.package);
    }

    void take_in(WindowInput input);
    void draw(double scale, const RenderOptions& options);
    void draw_where_needed();
    void give_back_at_rest();
    void record_path();
    void remember(const std::filesystem::path& package);
    void present();
    [[nodiscard]] bool is_moving() const;

    Lumigraph lumigraph;
    ViewerState state;
    Eigen::Vector2i size_px;  ///< Of the picture, which a minimised window does not shrink.
    GlfwWindow window;
    Panels panels;
    LumigraphRenderer renderer;
    FrameTarget target;
    Comparison comparison;
    std::filesystem::path recent_file;
    std::optional<DrawnFrame> drawn;
    MovingResolution resolution;
    TriangleBudget budget;
    double budget_frames_per_second = 0.0;  ///< That the budget was made for.
    FrameStatistics statistics;
    Clock::time_point last_motion = Clock::now() - std::chrono::hours(1);
    Clock::time_point last_step = Clock::now();
    bool is_memory_given_back = false;  ///< Since the eye last moved.
    bool steers = false;                ///< A drag that began on the picture goes on.
    bool holds_button = false;
    PathRecording recording;
};

void ViewerWindow::Implementation::take_in(WindowInput input) {
    const double seconds = seconds_since(last_step);
    last_step = Clock::now();
    const bool pressed = input.left_button || input.middle_button || input.right_button;
    if (pressed && !holds_button) steers = !panels.takes_mouse();
    holds_button = pressed;
    if (!steers) input.drag_px.setZero();
    if (panels.takes_mouse()) input.wheel_steps = 0.0;
    if (panels.takes_keys()) {
        input.flight.setZero();
        input.commands.clear();
    }
    for (const Command command : input.commands) apply(command, lumigraph, state);
    if (steer(input, seconds, size_px.x(), size_px.y(), state.navigation)) {
        last_motion = Clock::now();
    }
}

bool ViewerWindow::Implementation::is_moving() const {
    return seconds_since(last_motion) < kRestBeforeWhole_s;
}

void ViewerWindow::Implementation::draw(double scale, const RenderOptions& options) {
    const Eigen::Vector2i size =
        (scale * size_px.cast<double>()).array().round().matrix().cast<int>().cwiseMax(1);
    const DrawnFrame wanted{fitted_to(state.navigation.eye, size.x(), size.y()), options, scale};
    if (drawn && same(*drawn, wanted)) return;
    const Clock::time_point start = Clock::now();
    statistics.triangles = target.draw(renderer, wanted.eye, wanted.options).triangles;
    glFinish();
    statistics.frame_ms = 1000 * seconds_since(start);
    remember_frame_time(statistics);
    statistics.width_px = size.x();
    statistics.height_px = size.y();
    resolution.measured(scale, statistics.frame_ms);
    drawn = wanted;
}

/// While the eye moves, coarser where that keeps it smooth; at rest everything.
void ViewerWindow::Implementation::draw_where_needed() {
    const Eigen::Vector2i now_px = window.framebuffer_size_px();
    if (now_px.minCoeff() > 0) size_px = now_px;
    if (!is_moving()) return draw(1.0, state.render);
    RenderOptions moving = state.render;
    moving.smooth_silhouettes = false;
    const bool is_limited = state.frames_per_second > 0 && moving.mode == RenderMode::kAdaptive;
    if (!is_limited) return draw(resolution.scale_while_moving(), moving);
    if (budget_frames_per_second != state.frames_per_second) {
        budget = TriangleBudget(state.frames_per_second);
        budget_frames_per_second = state.frames_per_second;
    }
    draw(resolution.scale_while_moving(), budget.within(moving));
    budget.measured(statistics.triangles, statistics.frame_ms);
}

/// Frames of a moving eye take memory and free it again, each as much as it happens to need; a
/// picture that stays needs none of it.
void ViewerWindow::Implementation::give_back_at_rest() {
    const bool was_given_back = std::exchange(is_memory_given_back, !is_moving());
    if (is_memory_given_back && !was_given_back) release_free_memory();
}

void ViewerWindow::Implementation::record_path() {
    const std::string message =
        state.records_path
            ? recording.append(fitted_to(state.navigation.eye, size_px.x(), size_px.y()))
            : recording.end(std::filesystem::current_path());
    if (!message.empty()) statistics.message = message;
}

/// Without a list, or for what is not a package's folder, does nothing.
void ViewerWindow::Implementation::remember(const std::filesystem::path& package) {
    if (recent_file.empty()) return;
    try {
        if (!package.empty()) remember_package(package, recent_file);
    } catch (const Error& error) {
        statistics.message = error.what();
    }
    state.recent_packages = read_recent_packages(recent_file);
}

void ViewerWindow::Implementation::present() {
    const auto overlay = comparison.over_frame(state, size_px.x(), size_px.y(), renderer);
    target.show_in_window(size_px.x(), size_px.y());
    glViewport(0, 0, size_px.x(), size_px.y());
    panels.draw(lumigraph, comparison.views(), overlay, statistics, state);
    window.show_frame();
}

ViewerWindow::ViewerWindow(Lumigraph lumigraph, const WindowOptions& options)
    : implementation_(std::make_unique<Implementation>(std::move(lumigraph), options)) {}

ViewerWindow::~ViewerWindow() = default;

bool ViewerWindow::step(const WindowInput* in_place_of_user) {
    Implementation& viewer = *implementation_;
    const bool is_awaited = in_place_of_user || viewer.is_moving() || !viewer.drawn;
    WindowInput input = viewer.window.poll(is_awaited ? 0.0 : kIdleWait_s);
    if (in_place_of_user) input = *in_place_of_user;
    if (viewer.window.should_close()) return false;
    for (const std::filesystem::path& path : input.dropped) open_package(path);
    if (const auto chosen = std::exchange(viewer.state.package_to_open, {}); !chosen.empty())
        open_package(chosen);
    viewer.take_in(input);
    viewer.window.wait_for_vsync(viewer.state.waits_for_vsync);
    if (viewer.state.wants_screenshot) {
        viewer.state.wants_screenshot = false;
        const auto path = next_screenshot_path(std::filesystem::current_path());
        try {
            write_screenshot_to(path);
            viewer.statistics.message = "wrote " + path.filename().string();
        } catch (const Error& error) {
            viewer.statistics.message = error.what();
        }
    }
    viewer.draw_where_needed();
    viewer.give_back_at_rest();
    viewer.record_path();
    viewer.present();
    return !viewer.state.wants_to_close;
}

void ViewerWindow::write_screenshot_to(const std::filesystem::path& path) {
    Implementation& viewer = *implementation_;
    viewer.draw(1.0, viewer.state.render);
    write_screenshot(path, viewer.target.read(), viewer.drawn->eye, viewer.drawn->options,
                     viewer.lumigraph.name);
}

void ViewerWindow::open_package(const std::filesystem::path& folder) {
    Implementation& viewer = *implementation_;
    const bool is_manifest = folder.filename() == "lumigraph.json";
    const std::filesystem::path package = is_manifest ? folder.parent_path() : folder;
    try {
        Lumigraph lumigraph = read_package(package);
        viewer.renderer = LumigraphRenderer(lumigraph);
        viewer.lumigraph = std::move(lumigraph);
    } catch (const Error& error) {
        viewer.statistics.message = std::string(error.what()) + " - " + error.advice();
        return;
    }
    const ViewerState old = viewer.state;
    viewer.state = first_state(viewer.lumigraph, old.render);
    viewer.state.shows_panel = old.shows_panel;
    viewer.state.shows_help = old.shows_help;
    viewer.state.waits_for_vsync = old.waits_for_vsync;
    viewer.state.frames_per_second = old.frames_per_second;
    viewer.comparison = Comparison({});
    viewer.drawn.reset();
    viewer.statistics.message = "opened " + viewer.lumigraph.name;
    viewer.remember(package);
    viewer.window.set_title(title_of(viewer.lumigraph));
}

ViewerState& ViewerWindow::state() { return implementation_->state; }
const FrameStatistics& ViewerWindow::statistics() const { return implementation_->statistics; }

void run_window(Lumigraph lumigraph, const WindowOptions& options) {
    ViewerWindow window(std::move(lumigraph), options);
    if (!options.screenshot_path.empty())
        return window.write_screenshot_to(options.screenshot_path);
    const auto is_interrupted = [&] { return options.progress && options.progress->interrupted(); };
    while (!is_interrupted() && window.step()) {
    }
}

}  // namespace lumi
