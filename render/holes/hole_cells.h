#pragma once

#include <Eigen/Core>
#include <functional>

#include "render/surroundings/picture_cells.h"

namespace lumi {

/// The width of the cells that are searched for holes, and the places asked along each side of one.
inline constexpr double kHoleCell_px = 16.0;
inline constexpr int kHoleSamples = 4;
/// The least share of a cell's places at which no view sees the scene for it to count as a hole:
/// outlines, along which some view always loses the surface, are none.
inline constexpr double kLeastHoleShare = 0.25;

/// The cells of a picture in which none of the views that were asked for depth sees the scene:
/// what they show there is stretched over a tear, or nothing. Places beyond the picture's border do
/// not count.
[[nodiscard]] PictureCells hole_cells(
    const Camera& camera, const std::function<bool(const Eigen::Vector2d& pixel)>& is_hole);

}  // namespace lumi
