#pragma once

#include <vector>

#include "calib/boards/board_pattern.h"
#include "calib/boards/dark_quads.h"
#include "calib/boards/disc_centres.h"
#include "calib/boards/lattice_basis.h"

namespace lumi {

/// A grid of separate shapes, or part of one.
struct GridPattern {
    std::vector<PatternNode> nodes;          ///< None: not found.
    std::vector<std::size_t> shape_of_node;  ///< Index of the quad or disc of each node.
    LatticeShape shape = LatticeShape::kOther;
    double size_per_pitch = 0.0;  ///< Side of a square or diameter of a disc, to the pitch.
    double median_step_px = 0.0;
};

/// Squares whose sides point to their neighbours. (The dark cells of a chessboard point there with
/// their corners, and are refused.) Each node comes with its four corners.
[[nodiscard]] GridPattern find_square_grid(const std::vector<DarkQuad>& quads);

/// Discs on a square lattice (also when it stands on a corner, as asymmetric grids do) or on a
/// hexagonal one: the shape of the discs themselves tells how the plane is tilted, and so which.
[[nodiscard]] GridPattern find_circle_grid(const std::vector<DiscImage>& discs);

}  // namespace lumi
