#include "calib/boards/lattice_basis.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "calib/work/median.h"

namespace lumi {
namespace {

LatticeShape shape_of(const Eigen::Matrix2d& gram) {
    const double length_ratio = std::sqrt(gram.diagonal().maxCoeff() / gram.diagonal().minCoeff());
    const double cosine = gram(0, 1) / std::sqrt(gram(0, 0) * gram(1, 1));
    constexpr double kMaxLengthRatio = 1.25;
    if (length_ratio > kMaxLengthRatio) return LatticeShape::kOther;
    return cosine < 0.25 ? LatticeShape::kSquare : LatticeShape::kHexagonal;
}

}  // namespace

LatticeBasis reduced_basis(const Eigen::Matrix2d& gram_of_found) {
    // Columns: the reduced steps in the found ones.
    Eigen::Matrix2i found_from_reduced = Eigen::Matrix2i::Identity();
    Eigen::Matrix2d gram = gram_of_found;
    const auto apply = [&](const Eigen::Matrix2i& step) {
        found_from_reduced = found_from_reduced * step;
        gram = step.cast<double>().transpose() * gram * step.cast<double>();
    };
    constexpr int kMaxSteps = 20;
    for (int count = 0; count < kMaxSteps; ++count) {
        // The second step is the longer one; turning the first keeps the handedness.
        if (gram(1, 1) < gram(0, 0)) apply((Eigen::Matrix2i() << 0, -1, 1, 0).finished());
        const int times = static_cast<int>(std::lround(gram(0, 1) / gram(0, 0)));
        if (times == 0) break;
        apply((Eigen::Matrix2i() << 1, -times, 0, 1).finished());
    }
    if (gram(0, 1) < 0) apply((Eigen::Matrix2i() << 0, -1, 1, 0).finished());
    LatticeBasis basis;
    const int determinant = found_from_reduced(0, 0) * found_from_reduced(1, 1) -
                            found_from_reduced(0, 1) * found_from_reduced(1, 0);
    basis.reduced_from_found << found_from_reduced(1, 1), -found_from_reduced(0, 1),
        -found_from_reduced(1, 0), found_from_reduced(0, 0);
    basis.reduced_from_found *= determinant;
    basis.gram = gram;
    basis.shape = shape_of(gram);
    return basis;
}

LatticeCell changed(const LatticeCell& cell, const Eigen::Matrix2i& reduced_from_found) {
    const Eigen::Vector2i result = reduced_from_found * Eigen::Vector2i(cell.column, cell.row);
    return {result.x(), result.y()};
}

Eigen::Vector2d position_of(const LatticeCell& cell, LatticeShape shape) {
    if (shape == LatticeShape::kHexagonal) {
        return {cell.column + 0.5 * cell.row, 0.5 * std::numbers::sqrt3 * cell.row};
    }
    return {static_cast<double>(cell.column), static_cast<double>(cell.row)};
}

Eigen::Matrix2d median_of(const std::vector<Eigen::Matrix2d>& matrices) {
    Eigen::Matrix2d result;
    std::vector<double> values(matrices.size());
    for (Eigen::Index entry = 0; entry < 4; ++entry) {
        std::transform(matrices.begin(), matrices.end(), values.begin(),
                       [&](const Eigen::Matrix2d& matrix) { return matrix(entry); });
        result(entry) = median_of(values);
    }
    return result;
}

}  // namespace lumi
