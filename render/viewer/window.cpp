#include "render/viewer/window.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "calib/work/error.h"
#include "calib/work/error_of_exception.h"
#include "calib/work/printable.h"
#include "calib/work/process_memory.h"
#include "calib/work/stopwatch.h"
#include "render/gl/capabilities.h"
#include "render/viewer/comparison.h"
#include "render/viewer/glfw_window.h"
#include "render/viewer/panels.h"
#include "render/viewer/recent_packages.h"
#include "render/viewer/screenshot.h"
#include "render/viewer/window_beginning.h"
#include "render/viewer/window_path.h"
#include "render/viewer/window_picture.h"

namespace lumi {

namespace {

/// How long the eye must rest before the whole picture is drawn.
constexpr double kRestBeforeWhole_s = 0.15;
constexpr double kIdleWait_s = 0.1;

std::string title_of(const Lumigraph& lumigraph) { return "lumi - " + lumigraph.name; }

/// A screenshot, its pose or a path, and no package.
bool may_hold_eyes(const std::filesystem::path& path) {
    std::error_code status;
    const bool has_such_a_name = path.extension() == ".json" || path.extension() == ".png";
    return has_such_a_name && path.filename() != kManifestName &&
           std::filesystem::is_regular_file(path, status);
}

}  // namespace

struct ViewerWindow::Implementation {
    Implementation(OpenedPackage opened, const WindowOptions& options)
        : state(state_at_beginning(opened, options)),
          lumigraph(std::move(opened.lumigraph)),
          size_px(first_size_px(options, state.navigation.eye.camera)),
          window(size_px.x(), size_px.y(), title_of(lumigraph), options.screenshot_path.empty()),
          panels(window),
          picture(lumigraph),
          comparison(std::move(opened.held_out), std::move(opened.likeness_words)),
          load(options.load),
          read_eyes(options.read_eyes),
          shown_exposures(options.exposures),
          recent_file(options.recent_file),
          progress(options.progress) {
        statistics.gl_description = query_capabilities().description;
        if (!opened.message.empty()) statistics.tell(opened.message);
        remember(state.package);
        const bool is_as_wished = options.width_px > 0 || !options.screenshot_path.empty();
        if (const float scale = window.content_scale(); !is_as_wished && scale > 1)
            window.enlarge(scale);
        if (options.eyes.size() > 1) eye_path.show(options.eyes, state);
    }

    void take_in(WindowInput input);
    void compare_as_wished();
    void draw_where_needed();
    void give_back_at_rest();
    void record_path() { eye_path.record(size_px, now_s(), state, statistics); }
    void keep_path_of_what_failed() noexcept;
    void open_eyes(const std::filesystem::path& file);
    bool show_read(const std::filesystem::path& package);
    void show_wished_exposures();
    void take_wished_screenshot();
    void write_screenshot_to(const std::filesystem::path& path);
    void remember(const std::filesystem::path& package);
    void present();
    [[nodiscard]] double now_s() const { return clock.elapsed().wall_s; }
    [[nodiscard]] bool is_moving() const;

    ViewerState state;
    Lumigraph lumigraph;
    Eigen::Vector2i size_px;  ///< Of the picture, which a minimised window does not shrink.
    GlfwWindow window;
    Panels panels;
    WindowPicture picture;
    Comparison comparison;
    PackageLoader load;
    EyesReader read_eyes;
    Exposures shown_exposures;
    std::filesystem::path recent_file;
    Progress* progress;  ///< May be null.
    FrameStatistics statistics;
    Stopwatch clock;
    double last_motion_s = -std::numeric_limits<double>::infinity();
    double last_step_s = 0.0;
    bool is_memory_given_back = false;  ///< Since the eye last moved.
    bool steers = false;                ///< A drag that began on the picture goes on.
    bool holds_button = false;
    WindowPath eye_path;
};

void ViewerWindow::Implementation::take_in(WindowInput input) {
    const double seconds = now_s() - last_step_s;
    last_step_s += seconds;
    const bool pressed = input.left_button || input.middle_button || input.right_button;
    if (input.pressed_at_px || (pressed && !holds_button))
        steers = !panels.takes_mouse(input.pressed_at_px);
    holds_button = pressed;
    if (!steers) input.drag_px.setZero();
    if (panels.takes_mouse(input.cursor_px)) input.wheel_steps = 0.0;
    if (panels.takes_keys()) {
        input.flight.setZero();
        input.commands.clear();
    }
    if (panels.has_open_list()) std::erase(input.commands, Command::kBack);
    for (const Command command : input.commands) apply(command, lumigraph, state);
    compare_as_wished();
    if (is_compared(comparison.views(), state)) {
        if (enlarge(input, size_px, state.enlargement)) last_motion_s = now_s();
    } else if (steers && input.double_clicked_at_px) {
        turn_about(*input.double_clicked_at_px, size_px, lumigraph, state.navigation);
    }
    if (steer(input, seconds, size_px.x(), size_px.y(), state.navigation)) {
        last_motion_s = now_s();
        state.replays_path = false;
    }
    if (!is_compared(comparison.views(), state)) state.enlargement = {};
}

void ViewerWindow::Implementation::compare_as_wished() {
    if (!std::exchange(state.wants_comparison, false)) return;
    if (comparison.views().empty())
        statistics.tell("no photograph of this package was held out, to compare with");
    compare_again_or_next(comparison.views(), lumigraph, state);
}

bool ViewerWindow::Implementation::is_moving() const {
    return now_s() - last_motion_s < kRestBeforeWhole_s;
}

void ViewerWindow::Implementation::draw_where_needed() {
    const Eigen::Vector2i now_px = window.framebuffer_size_px();
    if (now_px.minCoeff() > 0) size_px = now_px;
    if (is_moving()) return picture.draw_moving(state, size_px, statistics);
    picture.draw_whole(state, size_px, statistics);
}

/// Frames of a moving eye take memory and free it again, each as much as it happens to need; a
/// picture that stays needs none of it.
void ViewerWindow::Implementation::give_back_at_rest() {
    const bool was_given_back = std::exchange(is_memory_given_back, !is_moving());
    if (is_memory_given_back && !was_given_back) release_free_memory();
}

/// As where the window is closed. What made it fail counts more than what fails here.
void ViewerWindow::Implementation::keep_path_of_what_failed() noexcept {
    try {
        const std::string message = eye_path.end();
        if (progress && !message.empty()) progress->note(message);
    } catch (...) {
        return;
    }
}

/// Eyes that cannot be read leave a message. A path that is being recorded is written before
/// another takes its place.
void ViewerWindow::Implementation::open_eyes(const std::filesystem::path& file) {
    try {
        std::vector<TimedEye> eyes = read_eyes(file);
        const bool is_path = eyes.size() > 1;
        std::string said;
        if (is_path && std::exchange(state.records_path, false)) {
            record_path();
            said = statistics.message + "; ";
        }
        eye_path.show(std::move(eyes), state);
        statistics.tell(said + (is_path ? "replays " : "stands at the eye of ") +
                        printable(file.filename().string()));
    } catch (const std::exception& exception) {
        const auto error = error_of_exception(exception);
        if (!error) throw;
        statistics.tell_failure(std::string(error->what()) + " - " + error->advice());
    }
}

/// Whether it could be read; else what is shown stays, with a message.
bool ViewerWindow::Implementation::show_read(const std::filesystem::path& package) {
    try {
        OpenedPackage opened = load(package, state.exposures);
        picture.change_to(opened.lumigraph);
        lumigraph = std::move(opened.lumigraph);
        comparison = Comparison(std::move(opened.held_out), std::move(opened.likeness_words));
        state.planned = std::move(opened.planned);
        state.render.fade_beyond_capture = opened.fade_beyond_capture;
        statistics.tell("opened " + lumigraph.name +
                        (opened.message.empty() ? "" : ": " + opened.message));
    } catch (const std::exception& exception) {
        const auto error = error_of_exception(exception);
        if (!error) throw;
        statistics.tell_failure(std::string(error->what()) + " - " + error->advice());
        return false;
    }
    state.package = package;
    shown_exposures = state.exposures;
    return true;
}

/// Without a list, or for what is not a package's folder, does nothing.
void ViewerWindow::Implementation::remember(const std::filesystem::path& package) {
    if (recent_file.empty()) return;
    try {
        if (!package.empty()) remember_package(package, recent_file);
    } catch (const Error& error) {
        statistics.tell_failure(error.what());
    }
    state.recent_packages = read_recent_packages(recent_file);
}

void ViewerWindow::Implementation::show_wished_exposures() {
    if (state.exposures == shown_exposures) return;
    const bool fades = state.render.fade_beyond_capture;
    if (!show_read(state.package)) state.exposures = shown_exposures;
    state.render.fade_beyond_capture = fades;
    // The file may have changed.
    state.view_index = std::min(state.view_index, static_cast<int>(lumigraph.views.size()) - 1);
    state.planned_index = std::min(state.planned_index, static_cast<int>(state.planned.size()) - 1);
}

void ViewerWindow::Implementation::write_screenshot_to(const std::filesystem::path& path) {
    picture.draw_whole(state, size_px, statistics);
    write_screenshot(path, picture.target().read(), picture.drawn()->eye, picture.drawn()->options,
                     shown_exposures, lumigraph.name);
}

void ViewerWindow::Implementation::take_wished_screenshot() {
    if (!std::exchange(state.wants_screenshot, false)) return;
    try {
        const auto path = next_screenshot_path(written_into());
        write_screenshot_to(path);
        statistics.tell("wrote " + path.string());
    } catch (const std::exception& exception) {
        const auto error = error_of_exception(exception);
        if (!error) throw;
        statistics.tell_failure(error->what());
    }
}

void ViewerWindow::Implementation::present() {
    const auto overlay = comparison.over_frame(state, size_px.x(), size_px.y(), picture.renderer());
    picture.target().show_in_window(size_px.x(), size_px.y());
    glViewport(0, 0, size_px.x(), size_px.y());
    panels.draw(lumigraph, comparison.views(), overlay, statistics, state);
    window.show_frame();
}

ViewerWindow::ViewerWindow(OpenedPackage opened, const WindowOptions& options)
    : implementation_(std::make_unique<Implementation>(std::move(opened), options)) {}

ViewerWindow::~ViewerWindow() = default;

bool ViewerWindow::step(const WindowInput* in_place_of_user) {
    try {
        return step_unguarded(in_place_of_user);
    } catch (...) {
        implementation_->keep_path_of_what_failed();
        throw;
    }
}

bool ViewerWindow::step_unguarded(const WindowInput* in_place_of_user) {
    Implementation& viewer = *implementation_;
    const bool is_awaited = in_place_of_user || viewer.is_moving() || viewer.state.replays_path ||
                            !viewer.picture.drawn();
    WindowInput input = viewer.window.poll(is_awaited ? 0.0 : kIdleWait_s);
    if (in_place_of_user) input = *in_place_of_user;
    for (const std::filesystem::path& path : input.dropped) {
        if (viewer.read_eyes && may_hold_eyes(path)) {
            viewer.open_eyes(path);
        } else {
            open_package(path);
        }
    }
    if (const auto chosen = std::exchange(viewer.state.package_to_open, {}); !chosen.empty())
        open_package(chosen);
    viewer.show_wished_exposures();
    viewer.take_in(input);
    if (viewer.eye_path.replay(viewer.now_s(), viewer.state)) viewer.last_motion_s = viewer.now_s();
    viewer.window.fill_screen(viewer.state.fills_screen);
    viewer.window.wait_for_vsync(viewer.state.waits_for_vsync);
    viewer.take_wished_screenshot();
    viewer.draw_where_needed();
    viewer.give_back_at_rest();
    // A path is not lost with its window.
    const bool closes = viewer.state.wants_to_close || viewer.window.should_close();
    if (closes) {
        viewer.state.records_path = false;
        viewer.state.writes_path_again = true;
    }
    viewer.record_path();
    viewer.present();
    return !closes;
}

void ViewerWindow::write_screenshot_to(const std::filesystem::path& path) {
    implementation_->write_screenshot_to(path);
}

void ViewerWindow::open_package(const std::filesystem::path& folder) {
    Implementation& viewer = *implementation_;
    if (!viewer.show_read(package_meant_by(folder))) return;
    // A path belongs to its scene.
    viewer.state.records_path = false;
    viewer.state.writes_path_again = true;
    viewer.record_path();
    viewer.eye_path.forget();
    viewer.state = state_after_opening(viewer.lumigraph, viewer.state);
    viewer.remember(viewer.state.package);
    viewer.window.set_title(title_of(viewer.lumigraph));
}

void ViewerWindow::go_to_photograph(int view_index) {
    lumi::go_to_photograph(view_index, implementation_->lumigraph, implementation_->state);
}

ViewerState& ViewerWindow::state() { return implementation_->state; }
const FrameStatistics& ViewerWindow::statistics() const { return implementation_->statistics; }
const std::vector<HeldOutView>& ViewerWindow::held_out() const {
    return implementation_->comparison.views();
}

void run_window(OpenedPackage opened, const WindowOptions& options) {
    ViewerWindow window(std::move(opened), options);
    if (!options.screenshot_path.empty())
        return window.write_screenshot_to(options.screenshot_path);
    while (window.step()) {
        if (options.progress && options.progress->interrupted())
            window.state().wants_to_close = true;
    }
}

}  // namespace lumi
