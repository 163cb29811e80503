#pragma once

#include <array>
#include <vector>

#include "render/depth_mesh/depth_lattice.h"

namespace lumi {

/// For each node of a lattice, the error in pixels of the right triangles whose long side it
/// halves, and of all triangles within them: what decides whether they are split.
///
/// The lattice is laid into a square whose side is a power of two, or, where it is much longer than
/// wide, into a row of such squares, each halved by the diagonal that its neighbours are not.
/// Infinite where a triangle contains a tear or a change between seen and filled.
class SplitErrors {
 public:
    /// Errors of filled depth are divided by `guess_error_ratio`: it is a guess anyway.
    SplitErrors(const DepthLattice& lattice, double guess_error_ratio);

    /// The side of a square, in steps of the lattice.
    [[nodiscard]] int side() const { return side_; }
    /// The number of squares along a row, and along a column; one of them is 1.
    [[nodiscard]] int squares_in_row() const { return last_column_ / side_; }
    [[nodiscard]] int squares_in_column() const { return last_row_ / side_; }
    [[nodiscard]] float at(const LatticeNode& node) const { return errors_[index(node)]; }

 private:
    [[nodiscard]] std::size_t index(const LatticeNode& node) const {
        return static_cast<std::size_t>(node.row) * static_cast<std::size_t>(last_column_ + 1) +
               static_cast<std::size_t>(node.column);
    }
    [[nodiscard]] bool is_on_squares(const LatticeNode& node) const {
        return node.column >= 0 && node.row >= 0 && node.column <= last_column_ &&
               node.row <= last_row_;
    }
    [[nodiscard]] float smallest_scale_error(const LatticeNode& at) const;
    [[nodiscard]] float interpolation_error(const LatticeNode& at, const LatticeNode& a,
                                            const LatticeNode& b) const;
    [[nodiscard]] float worst_of(const std::array<LatticeNode, 4>& children) const;
    void add_upright_level(int half);
    void add_diagonal_level(int half);

    const DepthLattice& lattice_;
    double guess_error_ratio_;
    int side_ = 1;
    int last_column_ = 1;  ///< Of the squares.
    int last_row_ = 1;
    std::vector<float> errors_;
};

}  // namespace lumi
