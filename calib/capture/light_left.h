#pragma once

#include <algorithm>
#include <cmath>

#include "calib/capture/camera.h"

namespace lumi {

/// How a lens darkens its pictures towards their corners (vignetting): of a surface's light
/// exp(falloff tan^2 a) is left at an angle a to the optical axis. A lens of which nothing is in
/// the way leaves cos^4 a of it, a falloff of about -2; stopped down, or corrected in the camera,
/// it comes closer to 0.

/// The squared tangent of the angle to the optical axis at a pixel.
[[nodiscard]] inline double squared_tangent(const Camera& camera, const Eigen::Vector2d& pixel) {
    return unproject(camera, pixel).head<2>().squaredNorm();
}

/// The share of its light that a surface keeps at a pixel.
[[nodiscard]] inline double light_left(double falloff, const Camera& camera,
                                       const Eigen::Vector2d& pixel) {
    return std::exp(falloff * squared_tangent(camera, pixel));
}

/// In the corner that is farthest from the optical axis.
[[nodiscard]] inline double light_left_in_corner(double falloff, const Camera& camera) {
    double least = 1.0;
    for (const int x : {0, camera.width_px})
        for (const int y : {0, camera.height_px})
            least = std::min(least, light_left(falloff, camera, {x, y}));
    return least;
}

}  // namespace lumi
