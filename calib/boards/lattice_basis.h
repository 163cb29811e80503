#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/boards/board_pattern.h"

namespace lumi {

/// How the nodes of a regular pattern lie to each other in its plane.
enum class LatticeShape {
    kSquare,     ///< Neighbours at right angles, as far in rows as in columns.
    kHexagonal,  ///< Six neighbours at 60 degrees.
    kOther,
};

/// A basis of a lattice, reduced: its two shortest steps.
struct LatticeBasis {
    Eigen::Matrix2i reduced_from_found = Eigen::Matrix2i::Identity();  ///< For cells.
    Eigen::Matrix2d gram = Eigen::Matrix2d::Identity();  ///< Products of the reduced steps.
    LatticeShape shape = LatticeShape::kOther;
};

/// The two shortest steps of the lattice whose steps have these scalar products (Gauss's
/// reduction), with the angle between them 60 to 90 degrees, and the shape that they make.
[[nodiscard]] LatticeBasis reduced_basis(const Eigen::Matrix2d& gram_of_found);

/// The cell of a node when the steps are those of `reduced_from_found`.
[[nodiscard]] LatticeCell changed(const LatticeCell& cell,
                                  const Eigen::Matrix2i& reduced_from_found);

/// Position of a cell in the pattern's plane; neighbours are 1 apart.
[[nodiscard]] Eigen::Vector2d position_of(const LatticeCell& cell, LatticeShape shape);

/// Entry by entry the median: a few bad matrices do not count. Expects at least one.
[[nodiscard]] Eigen::Matrix2d median_of(const std::vector<Eigen::Matrix2d>& matrices);

}  // namespace lumi
