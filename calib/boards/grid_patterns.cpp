#include "calib/boards/grid_patterns.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr int kLeastSquares = 6;  // Each has four corners.
constexpr int kLeastDiscs = 9;

/// Steps to the neighbours as columns.
Eigen::Matrix2d steps_of(const LatticePrediction& local) {
    Eigen::Matrix2d steps;
    steps << local.column_step_px, local.row_step_px;
    return steps;
}

/// The corners of a square in the order of columns and rows; none when its sides do not point
/// along the lattice.
std::vector<Eigen::Vector2d> ordered_corners(const DarkQuad& quad, const Eigen::Matrix2d& steps,
                                             std::vector<double>& sizes) {
    std::vector<Eigen::Vector2d> ordered(4);
    std::array<bool, 4> is_set{};
    const Eigen::Matrix2d cells_from_px = steps.inverse();
    double size = 0;
    for (const Eigen::Vector2d& corner_px : quad.corners_px) {
        const Eigen::Vector2d at = cells_from_px * (corner_px - quad.centre_px);
        constexpr double kLeastShare = 0.5;  // A corner that points to a neighbour has 0.
        if (at.cwiseAbs().minCoeff() < kLeastShare * at.cwiseAbs().maxCoeff()) return {};
        const std::size_t place = at.y() < 0 ? (at.x() < 0 ? 0 : 1) : (at.x() < 0 ? 3 : 2);
        if (is_set[place]) return {};
        is_set[place] = true;
        ordered[place] = corner_px;
        size += at.cwiseAbs().sum() / 4;
    }
    sizes.push_back(size);
    return ordered;
}

}  // namespace

GridPattern find_square_grid(const std::vector<DarkQuad>& quads) {
    GridPattern pattern;
    std::vector<Eigen::Vector2d> centres;
    for (const DarkQuad& quad : quads) centres.push_back(quad.centre_px);
    const LinkTest alike = [&](std::size_t from, std::size_t to, int columns, int rows) {
        const double ratio = quads[from].side_px / quads[to].side_px;
        constexpr double kMaxRatio = 1.6;
        const double allowed = std::pow(kMaxRatio, std::abs(columns) + std::abs(rows));
        if (ratio > allowed || ratio < 1 / allowed) return false;
        const double step_px = (centres[from] - centres[to]).norm();
        return step_px > 1.02 * std::min(quads[from].side_px, quads[to].side_px);
    };
    const Lattice lattice =
        largest_lattice(PointGrid(centres), alike, {.tolerance = 0.4, .min_nodes = kLeastSquares});
    if (lattice.empty()) return pattern;

    // Steps in units of each square's own sides tell the basis.
    std::vector<Eigen::Matrix2d> grams;
    for (const auto& [cell, index] : lattice) {
        const auto local = fit_around(lattice, centres, cell);
        if (!local) continue;
        const auto& corners = quads[index].corners_px;
        Eigen::Matrix2d sides;
        sides << 0.5 * (corners[1] - corners[0] + corners[2] - corners[3]),
            0.5 * (corners[3] - corners[0] + corners[2] - corners[1]);
        const Eigen::Matrix2d steps_in_sides = sides.inverse() * steps_of(*local);
        if (steps_in_sides.allFinite()) {
            grams.emplace_back(steps_in_sides.transpose() * steps_in_sides);
        }
    }
    if (grams.empty()) return pattern;
    const LatticeBasis basis = reduced_basis(median_of(grams));
    if (basis.shape != LatticeShape::kSquare) return pattern;

    Lattice reduced;
    for (const auto& [cell, index] : lattice) {
        reduced[changed(cell, basis.reduced_from_found)] = index;
    }
    std::vector<double> sizes;
    std::vector<double> steps_px;
    for (const auto& [cell, index] : reduced) {
        const auto local = fit_around(reduced, centres, cell);
        if (!local) continue;
        auto corners = ordered_corners(quads[index], steps_of(*local), sizes);
        if (corners.empty()) continue;
        pattern.nodes.push_back({cell, centres[index], std::move(corners)});
        pattern.shape_of_node.push_back(index);
        steps_px.push_back(std::min(local->column_step_px.norm(), local->row_step_px.norm()));
    }
    if (2 * pattern.nodes.size() < lattice.size() || pattern.nodes.size() < kLeastSquares)
        return {};
    pattern.shape = basis.shape;
    pattern.size_per_pitch = median_of(sizes);
    pattern.median_step_px = median_of(steps_px);
    return pattern;
}

GridPattern find_circle_grid(const std::vector<DiscImage>& discs) {
    GridPattern pattern;
    std::vector<Eigen::Vector2d> centres;
    for (const DiscImage& disc : discs) centres.push_back(disc.centre_px);
    const LinkTest alike = [&](std::size_t from, std::size_t to, int columns, int rows) {
        if (discs[from].contrast * discs[to].contrast < 0) return false;
        const double ratio = std::sqrt(discs[from].area_px2 / discs[to].area_px2);
        constexpr double kMaxRatio = 1.45;
        const double allowed = std::pow(kMaxRatio, std::abs(columns) + std::abs(rows));
        return ratio < allowed && ratio > 1 / allowed;
    };
    const Lattice lattice = largest_lattice(PointGrid(centres), alike, {.min_nodes = kLeastDiscs});
    if (lattice.empty()) return pattern;

    // A disc of radius r has moments r^2 / 4 in the plane: it measures the steps in its radius.
    std::vector<Eigen::Matrix2d> grams;
    std::vector<double> steps_px;
    for (const auto& [cell, index] : lattice) {
        const auto local = fit_around(lattice, centres, cell);
        if (!local) continue;
        const Eigen::Matrix2d steps = steps_of(*local);
        grams.emplace_back(steps.transpose() * discs[index].moments_px2.inverse() * steps / 4);
        steps_px.push_back(std::min(local->column_step_px.norm(), local->row_step_px.norm()));
    }
    if (grams.empty()) return pattern;
    const LatticeBasis basis = reduced_basis(median_of(grams));
    if (basis.shape == LatticeShape::kOther) return pattern;
    for (const auto& [cell, index] : lattice) {
        pattern.nodes.push_back({changed(cell, basis.reduced_from_found), centres[index], {}});
        pattern.shape_of_node.push_back(index);
    }
    pattern.shape = basis.shape;
    pattern.size_per_pitch = 2 / std::sqrt(0.5 * basis.gram.trace());
    pattern.median_step_px = median_of(steps_px);
    constexpr double kTouching = 1.0;
    if (pattern.size_per_pitch >= kTouching) return {};
    return pattern;
}

}  // namespace lumi
