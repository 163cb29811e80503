#include "render/depth_mesh/split_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumi {
namespace {

/// A square is at most so many times as long as the lattice's shorter side: of a larger one the
/// lattice would fill next to nothing.
constexpr int kMostShorterSides = 8;

/// Of the squares that hold so many nodes.
int last_node(int nodes, int side) { return std::max(1, (nodes - 1 + side - 1) / side) * side; }

}  // namespace

SplitErrors::SplitErrors(const DepthLattice& lattice, double guess_error_ratio)
    : lattice_(lattice), guess_error_ratio_(guess_error_ratio) {
    while (side_ + 1 < std::max(lattice.columns(), lattice.rows())) side_ *= 2;
    while (side_ > kMostShorterSides * std::min(lattice.columns(), lattice.rows())) side_ /= 2;
    last_column_ = last_node(lattice.columns(), side_);
    last_row_ = last_node(lattice.rows(), side_);
    errors_.assign(index({last_column_, last_row_}) + 1, 0.0F);
    // From the finest triangles up, so that a triangle knows the errors of those within it.
    for (int half = 1; half <= side_ / 2; half *= 2) {
        add_upright_level(half);
        add_diagonal_level(half);
    }
}

/// Triangles whose long side, of length 2 * half, lies along a row or a column.
void SplitErrors::add_upright_level(int half) {
    for (int row = 0; row <= last_row_; row += half) {
        const bool odd_row = (row / half) % 2 == 1;
        for (int column = odd_row ? 0 : half; column <= last_column_; column += 2 * half) {
            const LatticeNode at{column, row};
            const LatticeNode a =
                odd_row ? LatticeNode{column, row - half} : LatticeNode{column - half, row};
            const LatticeNode b =
                odd_row ? LatticeNode{column, row + half} : LatticeNode{column + half, row};
            const int quarter = half / 2;
            const float within = half == 1 ? smallest_scale_error(at)
                                           : worst_of({{{column - quarter, row - quarter},
                                                        {column + quarter, row - quarter},
                                                        {column - quarter, row + quarter},
                                                        {column + quarter, row + quarter}}});
            errors_[index(at)] = std::max(within, interpolation_error(at, a, b));
        }
    }
}

/// Triangles whose long side is the diagonal of a square cell of side 2 * half.
void SplitErrors::add_diagonal_level(int half) {
    for (int row = half; row <= last_row_; row += 2 * half) {
        for (int column = half; column <= last_column_; column += 2 * half) {
            const bool falls = ((column - half) / (2 * half) + (row - half) / (2 * half)) % 2 == 0;
            const int turn = falls ? half : -half;
            const float straight = interpolation_error({column, row}, {column - half, row - turn},
                                                       {column + half, row + turn});
            const float within = worst_of({{{column - half, row},
                                            {column + half, row},
                                            {column, row - half},
                                            {column, row + half}}});
            errors_[index({column, row})] = std::max(within, straight);
        }
    }
}

float SplitErrors::interpolation_error(const LatticeNode& at, const LatticeNode& a,
                                       const LatticeNode& b) const {
    if (!lattice_.contains(at.column, at.row)) return 0.0F;
    const double straight =
        0.5 * (static_cast<double>(lattice_.continued_inverse_depth(a.column, a.row)) +
               static_cast<double>(lattice_.continued_inverse_depth(b.column, b.row)));
    const double here = lattice_.inverse_depth(at.column, at.row);
    const double counts = lattice_.is_seen(at.column, at.row) ? 1.0 : 1.0 / guess_error_ratio_;
    return static_cast<float>(counts * std::abs(here - straight) * lattice_.disparity_px());
}

float SplitErrors::smallest_scale_error(const LatticeNode& at) const {
    constexpr float kMustSplit = std::numeric_limits<float>::infinity();
    if (!lattice_.contains(at.column, at.row)) return 0.0F;
    constexpr std::array<LatticeNode, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    for (const LatticeNode& step : kSteps) {
        const LatticeNode other{at.column + step.column, at.row + step.row};
        if (!lattice_.contains(other.column, other.row)) continue;
        if (lattice_.tears_between(at, other) ||
            lattice_.is_seen(at.column, at.row) != lattice_.is_seen(other.column, other.row))
            return kMustSplit;
    }
    return 0.0F;
}

float SplitErrors::worst_of(const std::array<LatticeNode, 4>& children) const {
    float worst = 0.0F;
    for (const LatticeNode& child : children)
        if (is_on_squares(child)) worst = std::max(worst, at(child));
    return worst;
}

}  // namespace lumi
