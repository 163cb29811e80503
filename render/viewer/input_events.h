#pragma once

#include <Eigen/Core>
#include <array>
#include <deque>
#include <optional>

#include "render/viewer/window_input.h"

namespace lumi {

/// What a window tells of mouse and keys, event by event in their order, until it is asked for.
/// However long that takes, the way of the cursor counts where a button was held on it and nowhere
/// else, and what was pressed shortly is not lost. Keys and buttons are GLFW's codes.
class InputEvents {
 public:
    /// In pixels of the framebuffer, as all places here.
    explicit InputEvents(const Eigen::Vector2d& cursor_px) : cursor_px_(cursor_px) {}

    void cursor_moved_to(const Eigen::Vector2d& cursor_px);
    /// `clock_s` grows; two presses of the left button soon after each other are a double click.
    void button_changed(int button, bool is_pressed, double clock_s);
    void key_changed(int key, bool is_pressed);
    void wheel_turned(double steps);
    void asked_for(Command command);
    void dropped(const std::filesystem::path& path);

    /// What happened since the last call, up to the end of one gesture: a drag with the same
    /// buttons and the same of Shift and Ctrl held. Of a gesture that goes on, what there is.
    [[nodiscard]] WindowInput taken();
    /// Whether more has happened than `taken` gave.
    [[nodiscard]] bool has_more() const { return gestures_.size() > 1; }

 private:
    struct Press {
        Eigen::Vector2d at_px;
        double clock_s;
    };

    [[nodiscard]] WindowInput& now() { return gestures_.back(); }
    /// Only with what is held.
    [[nodiscard]] WindowInput begun() const;
    void begin_another_after_a_drag();
    [[nodiscard]] bool holds_button() const;
    void count_click(double clock_s);

    Eigen::Vector2d cursor_px_;
    std::array<bool, 3> held_buttons_{};  ///< Left, right, middle, as GLFW counts them.
    std::array<bool, 6> held_flight_{};   ///< kFlightKeys.
    std::array<bool, 6> flown_{};       ///< The same, or held for a while since the gesture began.
    std::array<bool, 2> held_shift_{};  ///< Left, right.
    std::array<bool, 2> held_control_{};
    std::optional<Press> last_click_;
    std::deque<WindowInput> gestures_{1};
};

}  // namespace lumi
