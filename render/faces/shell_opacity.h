#pragma once

#include <algorithm>

namespace lumi {

/// How far inside of a photograph a point lies, `distance_px` from its border: 1 from a tenth of
/// the shorter side on. Close-ups end amid the scene, so that they must end softly.
[[nodiscard]] inline double inner_share(double distance_px, double shorter_side_px) {
    return std::clamp(10 * distance_px / shorter_side_px, 0.0, 1.0);
}

/// How much a shell over close-ups (CameraMesh::shells) covers of what is behind it at a point:
/// `fade` of its border (see `capture_fade`), times how much of the point its views see (`seen`:
/// weights times visibility, summed; half is enough), times how far inside of their photographs it
/// lies (`inside`: weighted mean of `inner_share`). Continuous in all of them. Shells are laid over
/// the mesh in their order, so that W = sum a_k prod_(finer) (1 - a_j) w^k, the mesh having a = 1.
[[nodiscard]] inline double shell_opacity(double fade, double seen, double inside) {
    const double share = std::clamp(2 * seen, 0.0, 1.0);
    return fade * inside * share * share * (3 - 2 * share);
}

}  // namespace lumi
