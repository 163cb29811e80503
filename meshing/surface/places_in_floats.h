#pragma once

#include <cfloat>

namespace lumi {

/// Whether floats hold places to a thousandth of the spacing between them. Both lengths may be sums
/// or typical values over the same places.
[[nodiscard]] inline bool floats_hold_places(double distance_from_origin, double spacing) {
    constexpr double kHeldShare = 1e-3;
    constexpr double kRoundingShare = 0.5 * static_cast<double>(FLT_EPSILON);
    return kRoundingShare * distance_from_origin <= kHeldShare * spacing;
}

}  // namespace lumi
