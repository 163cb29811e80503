#include "render/modes/affine_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

#include "render/modes/polygon_clipping.h"

namespace lumi {
namespace {

using Corners = std::vector<Eigen::Vector2d>;
using Box = Eigen::AlignedBox2d;

/// Affine errors are not chased further than this.
constexpr double kSmallest_px = 4.0;

enum class Coverage { kInside, kOutside, kMixed };

/// What one photograph looks like on a piece.
struct ViewOnPiece {
    Coverage coverage = Coverage::kOutside;
    std::vector<Eigen::Vector2d> pixels;  ///< One a corner, when inside.
    double error_px = 0.0;
};

Box bounds(const Corners& corners) {
    Box box;
    for (const Eigen::Vector2d& corner : corners) box.extend(corner);
    return box;
}

/// The relative error of linear interpolation between homogeneous values.
double half_spread(double low, double high) { return 0.5 * (high - low) / (high + low); }

ViewOnPiece look_up(const PlaneView& view, const Corners& corners, double border_px) {
    ViewOnPiece on_piece;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Eigen::Vector2d& corner : corners) {
        const Eigen::Vector3d pixel = view.view_from_eye * corner.homogeneous();
        low = std::min(low, pixel.z());
        high = std::max(high, pixel.z());
        on_piece.pixels.emplace_back(pixel.hnormalized());
    }
    if (high <= 0) return on_piece;
    on_piece.coverage = Coverage::kMixed;
    if (low <= 0) return on_piece;
    const Box box = bounds(on_piece.pixels);
    const Eigen::Array2d size(view.width_px, view.height_px);
    if ((box.max().array() <= 0).any() || (box.min().array() >= size).any())
        on_piece.coverage = Coverage::kOutside;
    else if ((box.min().array() >= border_px).all() &&
             (box.max().array() <= size - border_px).all())
        on_piece.coverage = Coverage::kInside;
    on_piece.error_px = box.diagonal().norm() * half_spread(low, high);
    return on_piece;
}

class PieceCutter {
 public:
    PieceCutter(const FacePolygon& polygon, const std::vector<PlaneView>& views,
                const Eigen::Vector3d& plane, const AffinePieceOptions& options,
                BlendTriangles& affine, std::vector<FacePolygon>& exact)
        : polygon_(polygon),
          views_(views),
          plane_(plane),
          options_(options),
          affine_(affine),
          exact_(exact) {}

    void cut(const Corners& corners) {
        if (corners.size() < 3) return;
        const Eigen::Vector2d size = bounds(corners).sizes();
        std::array<ViewOnPiece, 3> on_piece;
        bool any_mixed = false;
        bool any_inside = false;
        for (std::size_t k = 0; k < 3; ++k) {
            if (polygon_.side_lines[k].isZero(0)) continue;
            on_piece[k] = look_up(views_[static_cast<std::size_t>(polygon_.view_indices[k])],
                                  corners, options_.border_px);
            any_mixed = any_mixed || on_piece[k].coverage == Coverage::kMixed;
            any_inside = any_inside || on_piece[k].coverage == Coverage::kInside;
        }
        if (any_mixed) {
            if (size.maxCoeff() <= options_.min_size_px) return keep_exact(corners);
            return halve(corners, size);
        }
        if (!any_inside) return;
        const std::vector<std::array<double, 3>> sides = visible_sides(corners, on_piece);
        if (is_affine(on_piece, sides)) return keep_affine(corners, on_piece, sides);
        if (size.maxCoeff() <= kSmallest_px) return keep_exact(corners);
        halve(corners, size);
    }

 private:
    void halve(const Corners& corners, const Eigen::Vector2d& size) {
        const Eigen::Vector2d middle = bounds(corners).center();
        const bool wide = size.x() >= size.y();
        const Eigen::Vector3d line(wide ? 1 : 0, wide ? 0 : 1, wide ? -middle.x() : -middle.y());
        cut(clipped(corners, line));
        cut(clipped(corners, -line));
    }

    void keep_exact(const Corners& corners) const {
        exact_.push_back(polygon_);
        exact_.back().corners_px = corners;
    }

    /// Side products at the corners, zero for views that see nothing of the piece.
    [[nodiscard]] std::vector<std::array<double, 3>> visible_sides(
        const Corners& corners, const std::array<ViewOnPiece, 3>& on_piece) const {
        std::vector<std::array<double, 3>> sides(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                if (on_piece[k].coverage == Coverage::kInside)
                    sides[i][k] =
                        std::max(0.0, polygon_.side_lines[k].dot(corners[i].homogeneous()));
        return sides;
    }

    [[nodiscard]] bool is_affine(const std::array<ViewOnPiece, 3>& on_piece,
                                 const std::vector<std::array<double, 3>>& sides) const {
        double low = std::numeric_limits<double>::infinity();
        double high = 0;
        for (const auto& at_corner : sides) {
            const double sum = at_corner[0] + at_corner[1] + at_corner[2];
            low = std::min(low, sum);
            high = std::max(high, sum);
        }
        if (!(low > 0)) return false;
        for (std::size_t k = 0; k < 3; ++k) {
            double least = 1;
            double most = 0;
            for (const auto& at_corner : sides) {
                const double weight = at_corner[k] / (at_corner[0] + at_corner[1] + at_corner[2]);
                least = std::min(least, weight);
                most = std::max(most, weight);
            }
            if ((most - least) * half_spread(low, high) > options_.max_weight_error) return false;
            if (most * on_piece[k].error_px > options_.max_error_px) return false;
        }
        return true;
    }

    void keep_affine(const Corners& corners, const std::array<ViewOnPiece, 3>& on_piece,
                     const std::vector<std::array<double, 3>>& sides) {
        const auto first = static_cast<std::uint32_t>(affine_.vertices.size());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            BlendVertex vertex;
            vertex.pixel = {static_cast<float>(corners[i].x()), static_cast<float>(corners[i].y())};
            const double sum = sides[i][0] + sides[i][1] + sides[i][2];
            for (std::size_t k = 0; k < 3; ++k) {
                vertex.view_layers[k] = static_cast<float>(polygon_.view_indices[k]);
                vertex.weights[k] = static_cast<float>(sides[i][k] / sum);
                if (on_piece[k].coverage != Coverage::kInside) continue;
                vertex.view_pixels[k] = {static_cast<float>(on_piece[k].pixels[i].x()),
                                         static_cast<float>(on_piece[k].pixels[i].y())};
            }
            vertex.inverse_depth =
                static_cast<float>(std::max(0.0, plane_.dot(corners[i].homogeneous())));
            vertex.face_index = static_cast<float>(polygon_.face_index);
            affine_.vertices.push_back(vertex);
        }
        for (std::uint32_t i = 1; i + 1 < corners.size(); ++i)
            affine_.indices.insert(affine_.indices.end(), {first, first + i, first + i + 1});
    }

    const FacePolygon& polygon_;
    const std::vector<PlaneView>& views_;
    const Eigen::Vector3d& plane_;
    const AffinePieceOptions& options_;
    BlendTriangles& affine_;
    std::vector<FacePolygon>& exact_;
};

}  // namespace

void cut_into_affine_pieces(const FacePolygon& polygon, const std::vector<PlaneView>& views,
                            const Eigen::Vector3d& plane_inverse_depth,
                            const AffinePieceOptions& options, BlendTriangles& affine,
                            std::vector<FacePolygon>& exact) {
    PieceCutter(polygon, views, plane_inverse_depth, options, affine, exact)
        .cut(polygon.corners_px);
}

}  // namespace lumi
