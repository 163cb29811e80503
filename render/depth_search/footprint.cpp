#include "render/depth_search/footprint.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "render/transfer/polygon_extent.h"

namespace lumi {
namespace {

constexpr double kInset = 1.5;
/// Twice the area of a triangle, in square samples, in which nothing is looked for.
constexpr double kLeastDoubledArea = 1.0;

using Box = Eigen::AlignedBox2d;

Box square(int column, int row, int side) {
    return {side * Eigen::Vector2d(column, row), side * Eigen::Vector2d(column + 1, row + 1)};
}

/// Whether it holds for any of the squares of so many samples that the box touches.
template <class Holds>
bool holds_for_square(int side, const Box& box, const TiledDepth& depth, const Holds& holds) {
    const auto index = [&](double at, int samples) {
        return std::clamp(static_cast<int>(at), 0, samples - 1) / side;
    };
    const int end_row = index(box.max().y(), depth.height()) + 1;
    const int end_column = index(box.max().x(), depth.width()) + 1;
    for (int row = index(box.min().y(), depth.height()); row < end_row; ++row)
        for (int column = index(box.min().x(), depth.width()); column < end_column; ++column)
            if (holds(column, row)) return true;
    return false;
}

/// The triangle, drawn in, and what lies before it.
class Inner {
 public:
    Inner(const Footprint& triangle, double doubled_area, double margin) {
        Eigen::Matrix3d corners;
        for (int k = 0; k < 3; ++k)
            corners.row(k) = triangle.corners[static_cast<std::size_t>(k)].homogeneous();
        plane_ = corners.inverse() * triangle.inverse_depths;
        plane_.z() += margin;
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector2d& from = triangle.corners[k];
            const Eigen::Vector2d along = triangle.corners[(k + 1) % 3] - from;
            const Eigen::Vector2d inwards = Eigen::Vector2d(-along.y(), along.x()) *
                                            (std::copysign(1.0, doubled_area) / along.norm());
            sides_[k] = {inwards.x(), inwards.y(), -inwards.dot(from) - kInset};
        }
    }

    /// False where all of the box lies beyond one side.
    [[nodiscard]] bool may_touch(const Box& box) const {
        return std::all_of(sides_.begin(), sides_.end(), [&](const Eigen::Vector3d& side) {
            const Eigen::Vector2d innermost(side.x() > 0 ? box.max().x() : box.min().x(),
                                            side.y() > 0 ? box.max().y() : box.min().y());
            return side.dot(innermost.homogeneous()) >= 0;
        });
    }

    [[nodiscard]] bool has_sample_before(int column, int row, const TiledDepth& depth) const {
        const int end_x = std::min((column + 1) * TiledDepth::kFine, depth.width());
        const int end_y = std::min((row + 1) * TiledDepth::kFine, depth.height());
        for (int y = row * TiledDepth::kFine; y < end_y; ++y)
            for (int x = column * TiledDepth::kFine; x < end_x; ++x)
                if (is_before(depth[depth.row_offset(y) + TiledDepth::column_offset(x)],
                              {x + 0.5, y + 0.5, 1.0}))
                    return true;
        return false;
    }

 private:
    [[nodiscard]] bool is_before(const TiledDepth::Sample& sample,
                                 const Eigen::Vector3d& centre) const {
        return sample.kind == DepthKind::kSeen &&
               static_cast<double>(sample.inverse_depth) > plane_.dot(centre) &&
               std::all_of(sides_.begin(), sides_.end(),
                           [&](const Eigen::Vector3d& side) { return side.dot(centre) >= 0; });
    }

    Eigen::Vector3d plane_;                 ///< Of inverse depth: what is nearer is before.
    std::array<Eigen::Vector3d, 3> sides_;  ///< 0 on the edges, more within.
};

}  // namespace

bool is_anything_before(const Footprint& triangle, double margin, const TiledDepth& depth) {
    if (depth.empty()) return false;
    const double least = triangle.inverse_depths.minCoeff() + margin;
    if (static_cast<double>(depth.nearest()) <= least) return false;
    const Box around = bounding_box(triangle.corners);
    // Of most triangles this tells that nothing is.
    const auto may_hold_coarse = [&](int column, int row) {
        return static_cast<double>(depth.coarse(column, row).nearest) > least;
    };
    if (!holds_for_square(TiledDepth::kCoarse, around, depth, may_hold_coarse)) return false;
    const Eigen::Vector2d ab = triangle.corners[1] - triangle.corners[0];
    const Eigen::Vector2d ac = triangle.corners[2] - triangle.corners[0];
    const double doubled_area = signed_doubled_area(ab, ac);
    if (std::abs(doubled_area) < kLeastDoubledArea) return false;
    const Inner inner(triangle, doubled_area, margin);
    const auto holds_fine = [&](int column, int row) {
        return static_cast<double>(depth.fine(column, row).nearest) > least &&
               inner.may_touch(square(column, row, TiledDepth::kFine)) &&
               inner.has_sample_before(column, row, depth);
    };
    return holds_for_square(TiledDepth::kCoarse, around, depth, [&](int column, int row) {
        const Box coarse = square(column, row, TiledDepth::kCoarse);
        return may_hold_coarse(column, row) && inner.may_touch(coarse) &&
               holds_for_square(TiledDepth::kFine, coarse.intersection(around), depth, holds_fine);
    });
}

}  // namespace lumi
