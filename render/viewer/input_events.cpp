#include "render/viewer/input_events.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "render/viewer/key_places.h"

namespace lumi {
namespace {

Eigen::Vector3d flight_of(const std::array<bool, 6>& keys) {
    Eigen::Vector3d flight = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i]) flight[kFlightKeys[i].axis] += kFlightKeys[i].direction;
    return flight;
}

bool holds(const std::array<bool, 2>& either) { return either[0] || either[1]; }

bool has_drag(const WindowInput& input) {
    return input.left_button || input.middle_button || input.right_button;
}

}  // namespace

bool InputEvents::holds_button() const {
    return std::find(held_buttons_.begin(), held_buttons_.end(), true) != held_buttons_.end();
}

WindowInput InputEvents::begun() const {
    WindowInput input;
    input.left_button = held_buttons_[GLFW_MOUSE_BUTTON_LEFT];
    input.middle_button = held_buttons_[GLFW_MOUSE_BUTTON_MIDDLE];
    input.right_button = held_buttons_[GLFW_MOUSE_BUTTON_RIGHT];
    input.shift = holds(held_shift_);
    input.control = holds(held_control_);
    input.flight = flight_of(held_flight_);
    return input;
}

/// What was dragged before stays a drag with the buttons and keys that were held then.
void InputEvents::begin_another_after_a_drag() {
    if (!has_drag(now())) return;
    gestures_.push_back(begun());
    flown_ = held_flight_;
}

void InputEvents::cursor_moved_to(const Eigen::Vector2d& cursor_px) {
    if (holds_button()) now().drag_px += cursor_px - cursor_px_;
    cursor_px_ = cursor_px;
}

void InputEvents::button_changed(int button, bool is_pressed, double clock_s) {
    if (button < 0 || button >= static_cast<int>(held_buttons_.size())) return;
    held_buttons_[static_cast<std::size_t>(button)] = is_pressed;
    if (is_pressed || holds_button()) begin_another_after_a_drag();
    if (!is_pressed) return;
    WindowInput held = begun();
    now().left_button = held.left_button;
    now().middle_button = held.middle_button;
    now().right_button = held.right_button;
    now().pressed_at_px = cursor_px_;
    if (button == GLFW_MOUSE_BUTTON_LEFT) count_click(clock_s);
}

void InputEvents::count_click(double clock_s) {
    constexpr double kLongestBetween_s = 0.4;
    constexpr double kFarthestBetween_px = 5.0;
    const bool is_second = last_click_ && clock_s - last_click_->clock_s <= kLongestBetween_s &&
                           (cursor_px_ - last_click_->at_px).norm() <= kFarthestBetween_px;
    if (is_second) now().double_clicked_at_px = cursor_px_;
    last_click_ = is_second ? std::nullopt : std::optional(Press{cursor_px_, clock_s});
}

void InputEvents::key_changed(int key, bool is_pressed) {
    const bool is_shift = key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT;
    const bool is_control = key == GLFW_KEY_LEFT_CONTROL || key == GLFW_KEY_RIGHT_CONTROL;
    const bool is_left = key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_LEFT_CONTROL;
    if (is_shift) held_shift_[is_left ? 0 : 1] = is_pressed;
    if (is_control) held_control_[is_left ? 0 : 1] = is_pressed;
    if (is_shift || is_control) {
        begin_another_after_a_drag();
        now().shift = holds(held_shift_);
        now().control = holds(held_control_);
    }
    for (std::size_t i = 0; i < kFlightKeys.size(); ++i) {
        if (kFlightKeys[i].key != key) continue;
        held_flight_[i] = is_pressed;
        // With Ctrl it is a command, also where that is let go before anybody asks.
        if (is_pressed && !holds(held_control_)) flown_[i] = true;
        now().flight = flight_of(flown_);
    }
}

void InputEvents::wheel_turned(double steps) { now().wheel_steps += steps; }
void InputEvents::asked_for(Command command) { now().commands.push_back(command); }
void InputEvents::dropped(const std::filesystem::path& path) { now().dropped.push_back(path); }

WindowInput InputEvents::taken() {
    WindowInput input = std::move(gestures_.front());
    gestures_.pop_front();
    input.cursor_px = cursor_px_;
    if (gestures_.empty()) {
        gestures_.push_back(begun());
        flown_ = held_flight_;
    }
    return input;
}

}  // namespace lumi
