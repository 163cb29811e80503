#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/boards/lattice.h"

namespace lumi {

/// A regular pattern found in a photograph: the nodes of a chessboard (corners), of a grid of
/// circles (centres of what was seen of each disc) or of a grid of squares (each with its corners).
struct PatternNode {
    LatticeCell cell;
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    /// Corners of a square, in the order (-,-), (+,-), (+,+), (-,+) of column and row; else none.
    std::vector<Eigen::Vector2d> corners_px;
};

}  // namespace lumi
