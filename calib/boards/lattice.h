#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "calib/boards/point_grid.h"

namespace lumi {

/// A column and a row of a regular pattern; where they count from is arbitrary.
struct LatticeCell {
    int column = 0;
    int row = 0;
    friend auto operator<=>(const LatticeCell&, const LatticeCell&) = default;
};

/// Points of a picture that were recognised as the nodes of a regular pattern.
using Lattice = std::map<LatticeCell, std::size_t>;

/// Whether the pattern may lead from one point to another by a step of (columns, rows).
using LinkTest = std::function<bool(std::size_t from, std::size_t to, int columns, int rows)>;

struct LatticeOptions {
    double tolerance = 0.25;         ///< Of a prediction, as a share of the step there. > 0.
    double max_misplacement = 0.22;  ///< Off what the nodes around say, as a share of the step.
    int max_gap = 2;    ///< Nodes may be missing between two that are there: one less. >= 1.
    int min_nodes = 9;  ///< Fewer are not a pattern. >= 4.
};

/// The largest lattice that grows among points of a picture.
///
/// A seed is a point and two of its neighbours whose parallelogram holds; the lattice grows from
/// there, each node predicted from a low polynomial through the nodes around it, so that
/// perspective and lens distortion are followed without a model of either (in the manner of Geiger
/// et al., Automatic camera and range sensor calibration using a single shot, ICRA 2012). Parts of
/// a pattern are as good as the whole: nothing about its size is needed. Nodes that lie off the
/// middle of their neighbours are removed at the end. The lattice is right-handed in the picture
/// (columns to rows turn as x to y), or empty.
[[nodiscard]] Lattice largest_lattice(const PointGrid& points, const LinkTest& may_link,
                                      const LatticeOptions& options = {});

/// Where the pattern lies at a cell, by a polynomial through nodes around it.
struct LatticePrediction {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    Eigen::Vector2d column_step_px = Eigen::Vector2d::Zero();  ///< To the next column.
    Eigen::Vector2d row_step_px = Eigen::Vector2d::Zero();     ///< To the next row.
};
/// Where the pattern is expected at a cell, from the nodes around it without its own; none when
/// they are too few.
[[nodiscard]] std::optional<LatticePrediction> predict(
    const Lattice& lattice, const std::vector<Eigen::Vector2d>& points_px, const LatticeCell& cell);
/// How the pattern runs at a cell, from its own node, where it has one, and those around it; none
/// when they are too few.
[[nodiscard]] std::optional<LatticePrediction> fit_around(
    const Lattice& lattice, const std::vector<Eigen::Vector2d>& points_px, const LatticeCell& cell);

/// First and last column and row; expects at least one node.
struct LatticeExtent {
    LatticeCell first;
    LatticeCell last;
    [[nodiscard]] int columns() const { return last.column - first.column + 1; }
    [[nodiscard]] int rows() const { return last.row - first.row + 1; }
};
[[nodiscard]] LatticeExtent extent_of(const Lattice& lattice);

}  // namespace lumi
