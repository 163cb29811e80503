#pragma once

#include <Eigen/Core>

#include "render/viewer/commands.h"
#include "render/viewer/opened_package.h"
#include "render/viewer/window.h"

namespace lumi {

/// What the window shows first. Throws Error (E-VIEW-NAME) for a photograph that is not there.
[[nodiscard]] ViewerState state_at_beginning(const OpenedPackage& opened,
                                             const WindowOptions& options);

/// As wished; else of a screenshot the photograph's own size, of a window one that fits a screen
/// (window_size.h).
[[nodiscard]] Eigen::Vector2i first_size_px(const WindowOptions& options, const Camera& camera);

}  // namespace lumi
