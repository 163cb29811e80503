#pragma once

#include <Eigen/Core>

#include "calib/capture/camera.h"

namespace lumi {

/// The smallest window that the panel fits into, its sections as they are at first.
inline constexpr int kLeastWindowWidth_px = 960;
inline constexpr int kLeastWindowHeight_px = 640;

/// Of a window for pictures of a camera: of their shape, and as large as they are where an ordinary
/// screen holds that and it holds the panel. Where one of their shape that holds the panel is
/// larger than the screen, it is cut to that.
[[nodiscard]] Eigen::Vector2i window_size_px(const Camera& camera);

}  // namespace lumi
