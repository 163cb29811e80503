#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "calib/capture/image.h"

namespace lumi {

/// Where the sides of a dark quadrilateral meet, found again from its approximate corners (in
/// pixels, clockwise as seen). Sides are straight lines through their edges near each corner, but
/// not at it, where blur rounds them. Edges are where brightness grows most going outwards: towards
/// a neighbour across a narrow gap, or a marker's bright cells within, it falls. None where a side
/// is too short or has too little contrast.
[[nodiscard]] std::optional<std::array<Eigen::Vector2d, 4>> corners_where_sides_meet(
    const GrayImage& picture, const std::array<Eigen::Vector2d, 4>& corners_px);

}  // namespace lumi
