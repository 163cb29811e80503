#include "render/modes/epipolar_walk.h"

#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

/// In samples: a ray that leaves a square is put so far into the next.
constexpr double kBeyondSquare = 1e-3;

/// A ray that was moved to where it is as far away as something is not before it, but for rounding.
constexpr double kRoundedDown = 1 - 1e-9;

bool is_before(double q, const EpipolarWalk::Place& place, const TiledDepth::Range& range) {
    return q * kRoundedDown > static_cast<double>(range.nearest) * place.z;
}

bool is_behind(double q, const EpipolarWalk::Place& place, const TiledDepth::Range& range) {
    return q < static_cast<double>(range.farthest) * place.z;
}

/// Into the range, also what is not a number: the point lies in the view's focal plane.
unsigned clamped(double place, int samples) {
    return static_cast<unsigned>(static_cast<int>(std::max(0.0, std::min(place, samples - 1.0))));
}

}  // namespace

EpipolarWalk::EpipolarWalk(const EpipolarLine& line_in_samples, const TiledDepth& depth)
    : line_(line_in_samples), depth_(depth) {
    // The derivative of a place by q has the sign of this, everywhere on the line.
    const Eigen::Vector3d& a = line_.at_infinity;
    const Eigen::Vector3d& e = line_.per_inverse_depth;
    x_falls_ = e.x() * a.z() > a.x() * e.z();
    y_falls_ = e.y() * a.z() > a.y() * e.z();
}

double EpipolarWalk::speed(const Place& place) const {
    const Eigen::Vector3d& step = line_.per_inverse_depth;
    const double x = step.x() - place.x * step.z();
    const double y = step.y() - place.y * step.z();
    return std::sqrt(x * x + y * y) / std::abs(place.z);
}

EpipolarWalk::Square EpipolarWalk::coarse_at(const Place& place) const {
    const int column = static_cast<int>(clamped(place.x, depth_.width()) / TiledDepth::kCoarse);
    const int row = static_cast<int>(clamped(place.y, depth_.height()) / TiledDepth::kCoarse);
    return {TiledDepth::kCoarse, column, row, depth_.coarse(column, row)};
}

EpipolarWalk::Square EpipolarWalk::fine_at(const Place& place) const {
    const int column = static_cast<int>(clamped(place.x, depth_.width()) / TiledDepth::kFine);
    const int row = static_cast<int>(clamped(place.y, depth_.height()) / TiledDepth::kFine);
    return {TiledDepth::kFine, column, row, depth_.fine(column, row)};
}

double EpipolarWalk::leaves(const Square& square, double q, double far_end) const {
    const Eigen::Vector3d& a = line_.at_infinity;
    const Eigen::Vector3d& e = line_.per_inverse_depth;
    const double x = x_falls_ ? square.side * square.column - kBeyondSquare
                              : square.side * (square.column + 1) + kBeyondSquare;
    const double y = y_falls_ ? square.side * square.row - kBeyondSquare
                              : square.side * (square.row + 1) + kBeyondSquare;
    const double at_x = (x * a.z() - a.x()) / (e.x() - x * e.z());
    const double at_y = (y * a.z() - a.y()) / (e.y() - y * e.z());
    double leaves = far_end;
    if (at_x < q) leaves = std::max(leaves, at_x);
    if (at_y < q) leaves = std::max(leaves, at_y);
    return leaves;
}

double EpipolarWalk::past_free(double q, double far_end) const {
    const int most_squares = depth_.width() + depth_.height();
    for (int i = 0; i < most_squares; ++i) {
        const Place place = at(q);
        Square square = coarse_at(place);
        if (!is_before(q, place, square.range)) square = fine_at(place);
        if (!is_before(q, place, square.range)) return q;
        const double meets_nearest = meets(static_cast<double>(square.range.nearest));
        const double leaves_it = leaves(square, q, far_end);
        if (meets_nearest < q && meets_nearest >= leaves_it) {
            q = std::max(far_end, meets_nearest);
            if (square.side == TiledDepth::kFine || q <= far_end) return q;
        } else {
            if (leaves_it <= far_end) return far_end;
            q = leaves_it;
        }
    }
    return q;
}

double EpipolarWalk::past_hiding(double q, double far_end) const {
    // Farther along the ray is also farther from the view, unless the ray comes back to it.
    if (line_.at_infinity.z() <= 0) return q;
    const int most_squares = depth_.width() + depth_.height();
    for (int i = 0; i < most_squares; ++i) {
        const Place place = at(q);
        Square square = coarse_at(place);
        if (!is_behind(q, place, square.range)) square = fine_at(place);
        if (!is_behind(q, place, square.range)) return q;
        const double leaves_it = leaves(square, q, far_end);
        if (leaves_it <= far_end) return far_end;
        q = leaves_it;
    }
    return q;
}

}  // namespace lumi
