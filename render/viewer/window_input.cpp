#include "render/viewer/window_input.h"

#include <algorithm>
#include <utility>

#include "render/paths/photograph_eye.h"

namespace lumi {
namespace {

/// Distances to the pivot per second.
constexpr double kFlightSpeed = 0.6;
constexpr double kFastFlightSpeed = 3.0;
/// A slow frame must not throw the eye across the scene.
constexpr double kLongestStep_s = 0.1;

Navigation dragged(const WindowInput& input, const Eigen::Vector2d& drag_px,
                   const Navigation& from) {
    const bool pans = input.right_button || input.middle_button;
    if (pans || (input.left_button && input.shift)) return pan(from, drag_px);
    if (input.left_button && input.control) return look(from, drag_px);
    if (input.left_button) return orbit(from, drag_px);
    return from;
}

}  // namespace

bool steer(const WindowInput& input, double seconds, int width_px, int height_px,
           Navigation& navigation) {
    const bool holds_button = input.left_button || input.middle_button || input.right_button;
    bool moved = false;
    if (holds_button && !input.drag_px.isZero()) {
        const double scale = fitting_scale(navigation.eye, width_px, height_px);
        navigation = dragged(input, input.drag_px / scale, navigation);
        moved = true;
    }
    if (input.wheel_steps != 0.0) {
        navigation = zoom(navigation, input.wheel_steps);
        moved = true;
    }
    if (!input.flight.isZero() && !input.control) {
        const double speed = input.shift ? kFastFlightSpeed : kFlightSpeed;
        navigation = fly(navigation, speed * std::min(seconds, kLongestStep_s) * input.flight);
        moved = true;
    }
    return moved;
}

bool enlarge(WindowInput& input, const Eigen::Vector2i& size_px, Enlargement& enlargement) {
    if (input.wheel_steps == 0.0) return false;
    const Eigen::Vector2d size = size_px.cast<double>();
    const Eigen::Vector2d cursor_px = input.cursor_px.value_or(0.5 * size);
    enlargement = enlarged_about(enlargement, cursor_px.cwiseQuotient(size),
                                 std::exchange(input.wheel_steps, 0.0));
    return true;
}

void turn_about(const Eigen::Vector2d& place_px, const Eigen::Vector2i& size_px,
                const Lumigraph& lumigraph, Navigation& navigation) {
    const Eye& eye = navigation.eye;
    // Eye and window have the middle of the picture in common.
    const Eigen::Vector2d from_middle =
        (place_px - 0.5 * size_px.cast<double>()) / fitting_scale(eye, size_px.x(), size_px.y());
    const Eigen::Vector2d middle(0.5 * eye.camera.width_px, 0.5 * eye.camera.height_px);
    navigation = turning_about(navigation, lumigraph, middle + from_middle);
}

}  // namespace lumi
