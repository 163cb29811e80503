#include "render/viewer/key_places.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <optional>

namespace lumi {

const std::array<FlightKey, 6> kFlightKeys{{{GLFW_KEY_W, 2, 1.0},
                                            {GLFW_KEY_A, 0, -1.0},
                                            {GLFW_KEY_S, 2, -1.0},
                                            {GLFW_KEY_D, 0, 1.0},
                                            {GLFW_KEY_Q, 1, 1.0},
                                            {GLFW_KEY_E, 1, -1.0}}};

namespace {

bool flies(int key) {
    return std::any_of(kFlightKeys.begin(), kFlightKeys.end(),
                       [&](const FlightKey& flight) { return flight.key == key; });
}

bool is_letter(int key) { return key >= GLFW_KEY_A && key <= GLFW_KEY_Z; }

bool is_bracket(int key) { return key == GLFW_KEY_LEFT_BRACKET || key == GLFW_KEY_RIGHT_BRACKET; }

bool is_ascii(const std::string& label) {
    return label.size() == 1 && static_cast<unsigned char>(label[0]) < 0x80;
}

/// GLFW's codes of letters and brackets are their capitals in ASCII.
std::optional<int> key_written_on(const std::string& label) {
    if (!is_ascii(label)) return std::nullopt;
    const int key = std::toupper(static_cast<unsigned char>(label[0]));
    if (!is_letter(key) && !is_bracket(key)) return std::nullopt;
    return key;
}

}  // namespace

int key_meant(int place, bool with_control, const KeyLabels& labels) {
    if (!with_control && flies(place)) return GLFW_KEY_UNKNOWN;
    std::string label = labels(place);
    std::optional<int> key = key_written_on(label);
    for (std::size_t i = 0; !with_control && key && flies(*key) && i < kFlightKeys.size(); ++i) {
        label = labels(*key);
        key = key_written_on(label);
    }
    if (key) return *key;
    // Another key has the letter, unless letters are not Latin.
    return is_letter(place) && is_ascii(label) ? GLFW_KEY_UNKNOWN : place;
}

std::string shown_place(int place, const KeyLabels& labels) {
    const std::string label = labels(place);
    if (label.empty() && is_letter(place)) return {static_cast<char>(place)};
    if (!is_ascii(label)) return label;
    return {static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])))};
}

std::string shown_key(const KeyBinding& binding, const KeyLabels& labels) {
    if (!is_letter(binding.key) && !is_bracket(binding.key)) return binding.shown;
    for (int place = GLFW_KEY_SPACE; place <= GLFW_KEY_WORLD_2; ++place) {
        if (key_meant(place, binding.with_control, labels) != binding.key) continue;
        const std::string shown = shown_place(place, labels);
        if (shown.empty()) break;
        return (binding.with_control ? "Ctrl+" : "") + shown;
    }
    return binding.shown;
}

}  // namespace lumi
