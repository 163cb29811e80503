#pragma once

#include <optional>
#include <vector>

#include "meshing/cameras/scene_centre.h"

namespace lumi {

/// Cameras behind each other along their line of sight, as of somebody who walked on.
struct ForwardMotion {
    double sway_share = 0.0;  ///< How far they stand beside the way, of how far along it (sigmas).
    double angle_deg = 0.0;   ///< Between the way and the mean line of sight.
};

/// From the scene such cameras lie in nearly one direction, in an order that is chance: no surface
/// lies between them. Nothing when they stand beside the way by more than a fifth of its length,
/// or when it leads more than 30 degrees past what they look at.
[[nodiscard]] std::optional<ForwardMotion> forward_motion(const std::vector<OpticalAxis>& axes);

}  // namespace lumi
