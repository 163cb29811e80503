#pragma once

#include <string>
#include <vector>

#include "calib/boards/dark_quads.h"

namespace lumi {

/// A dark quad that holds a marker's code.
struct MarkerReading {
    std::size_t quad = 0;
    int id = 0;
    std::size_t first_corner = 0;  ///< Of the quad: the marker's own top left.
};

/// The markers of one family.
struct MarkerFamily {
    std::string name;     ///< "4x4", "aruco", "36h11" ...; empty: no markers.
    int border_bits = 1;  ///< Width of the dark frame in cells.
    std::vector<MarkerReading> markers;
};

/// Reads every quad as a marker of each family that OpenCV knows (ArUco's predefined dictionaries
/// in their longest form, AprilTag 16h5 to 36h11), with frames one and two cells wide (Kalibr
/// prints two), and returns the family that most quads belong to. Fewer than three readings, or
/// readings of one id only, are chance.
[[nodiscard]] MarkerFamily read_markers(const GrayImage& picture,
                                        const std::vector<DarkQuad>& quads);

}  // namespace lumi
