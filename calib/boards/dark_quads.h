#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// A dark shape with four straight sides on brighter ground: a printed square, or a marker's frame.
struct DarkQuad {
    std::array<Eigen::Vector2d, 4> corners_px;  ///< Clockwise as seen (x to the right, y down).
    Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();  ///< Where the diagonals meet.
    double side_px = 0.0;                                 ///< The shortest.
    double contrast = 0.0;                                ///< Grey levels, ground minus shape.
};

/// Dark quadrilaterals, from outlines under thresholds of several neighbourhoods; shapes that
/// touch at their corners are parted. Corners are refined to a fraction of a pixel.
[[nodiscard]] std::vector<DarkQuad> detect_dark_quads(const GrayImage& picture);

}  // namespace lumi
