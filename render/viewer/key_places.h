#pragma once

#include <array>
#include <functional>
#include <string>

#include "render/viewer/commands.h"

namespace lumi {

/// A key that flies while it is held, by its place: GLFW's code, which is that of its letter on an
/// American keyboard. Along the eye's axis 0, 1 or 2 and in which direction.
struct FlightKey {
    int key;
    int axis;
    double direction;
};
/// W A S D, E (up) and Q (down): W A S D lie around a hand, wherever their letters are.
extern const std::array<FlightKey, 6> kFlightKeys;

/// What is written on the key at a place of the user's keyboard, as glfwGetKeyName tells it;
/// empty where it does not.
using KeyLabels = std::function<std::string(int place)>;

/// The key of key_bindings() that the user means by the key at a place: letters and brackets by
/// what is written on it, all others by their place. A letter that is written where W A S D Q E fly
/// is, without Ctrl, at the letter of that place instead, which has no other meaning: on a French
/// keyboard, whose W flies as Z does on others, "W" is "Z".
[[nodiscard]] int key_meant(int place, bool with_control, const KeyLabels& labels);

/// What the user presses for a binding: as KeyBinding::shown, with what is written on their key.
[[nodiscard]] std::string shown_key(const KeyBinding& binding, const KeyLabels& labels);

/// The same of a place.
[[nodiscard]] std::string shown_place(int place, const KeyLabels& labels);

}  // namespace lumi
