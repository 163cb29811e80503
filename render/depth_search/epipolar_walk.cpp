#include "render/depth_search/epipolar_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumi {
namespace {

/// In samples: a ray that leaves a square is put so far into the next.
constexpr double kBeyondSquare = 1e-3;

/// A ray that was moved to where it is as far away as something is not before it, but for rounding.
constexpr double kRoundedDown = 1 - 1e-9;

bool is_before(const EpipolarWalk::Place& place, const TiledDepth::Range& range) {
    return place.inverse_depth * kRoundedDown > static_cast<double>(range.nearest);
}

bool is_behind(const EpipolarWalk::Place& place, const TiledDepth::Range& range) {
    return place.inverse_depth < static_cast<double>(range.farthest);
}

/// Into the range, also what is not a number: the point lies in the view's focal plane.
unsigned clamped(double place, int samples) {
    return static_cast<unsigned>(static_cast<int>(std::max(0.0, std::min(place, samples - 1.0))));
}

/// What is not on the way at all takes forever.
double per_unit_of(double way) { return way == 0 ? std::numeric_limits<double>::max() : 1 / way; }

}  // namespace

EpipolarWalk::EpipolarWalk(const EpipolarLine& line_in_samples, const RayStretch& stretch,
                           const TiledDepth& depth)
    : depth_(depth) {
    const Eigen::Vector3d near = line_in_samples.homogeneous_at(stretch.near_end);
    const Eigen::Vector3d far = line_in_samples.homogeneous_at(stretch.far_end);
    const double near_eye_over_view = 1 / near.z();
    const double far_eye_over_view = 1 / far.z();
    begin_ = {near.x() * near_eye_over_view, near.y() * near_eye_over_view,
              stretch.near_end * near_eye_over_view};
    way_ = {far.x() * far_eye_over_view - begin_.x, far.y() * far_eye_over_view - begin_.y,
            stretch.far_end * far_eye_over_view - begin_.inverse_depth};
    begin_eye_over_view_ = near_eye_over_view;
    way_eye_over_view_ = far_eye_over_view - near_eye_over_view;
    per_sample_ = per_unit_of(std::sqrt(way_.x * way_.x + way_.y * way_.y));
    per_inverse_depth_ = per_unit_of(way_.inverse_depth);
    per_x_ = per_unit_of(way_.x);
    per_y_ = per_unit_of(way_.y);
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

double EpipolarWalk::leaves(const Square& square) const {
    const double x = way_.x < 0 ? square.side * square.column - kBeyondSquare
                                : square.side * (square.column + 1) + kBeyondSquare;
    const double y = way_.y < 0 ? square.side * square.row - kBeyondSquare
                                : square.side * (square.row + 1) + kBeyondSquare;
    return std::min((x - begin_.x) * per_x_, (y - begin_.y) * per_y_);
}

double EpipolarWalk::past_free(double share) const {
    const int most_squares = depth_.width() + depth_.height();
    for (int i = 0; i < most_squares; ++i) {
        const Place place = at(share);
        Square square = coarse_at(place);
        if (!is_before(place, square.range)) square = fine_at(place);
        if (!is_before(place, square.range)) return share;
        const double meets_nearest = meets(static_cast<double>(square.range.nearest));
        const double leaves_it = leaves(square);
        if (meets_nearest > share && meets_nearest <= leaves_it) {
            share = meets_nearest;
            if (square.side == TiledDepth::kFine || share >= 1) return std::min(share, 1.0);
        } else {
            if (leaves_it >= 1) return 1;
            share = leaves_it;
        }
    }
    return share;
}

double EpipolarWalk::past_hiding(double share) const {
    // Farther along the ray is also farther from the view, unless the ray comes back to it.
    if (way_.inverse_depth > 0) return share;
    const int most_squares = depth_.width() + depth_.height();
    for (int i = 0; i < most_squares; ++i) {
        const Place place = at(share);
        Square square = coarse_at(place);
        if (!is_behind(place, square.range)) square = fine_at(place);
        if (!is_behind(place, square.range)) return share;
        const double leaves_it = leaves(square);
        if (leaves_it >= 1) return 1;
        share = leaves_it;
    }
    return share;
}

}  // namespace lumi
