#pragma once

#include <Eigen/Core>

#include "calib/capture/camera.h"

namespace lumi {

/// The smallest window that the panel fits into, its sections as they are at first.
inline constexpr int kLeastWindowWidth_px = 960;
inline constexpr int kLeastWindowHeight_px = 640;

/// Of a window for pictures of a camera: their shape, where it fits on an ordinary screen and holds
/// the panel.
[[nodiscard]] Eigen::Vector2i window_size_px(const Camera& camera);

}  // namespace lumi
