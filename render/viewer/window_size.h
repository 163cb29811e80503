#pragma once

#include <Eigen/Core>

#include "calib/capture/camera.h"

namespace lumi {

/// The smallest window that the panel fits into, its sections as they are at first.
inline constexpr int kLeastWindowWidth_px = 960;
inline constexpr int kLeastWindowHeight_px = 640;

/// The size of a window for a camera's pictures: their own, scaled down to fit an ordinary screen
/// and up to hold the panel. Where both cannot be, the panel is held and the window cut to the
/// screen.
[[nodiscard]] Eigen::Vector2i window_size_px(const Camera& camera);

}  // namespace lumi
