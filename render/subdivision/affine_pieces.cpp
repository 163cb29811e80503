#include "render/subdivision/affine_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "calib/capture/inverse_depth_warp.h"
#include "render/transfer/polygon_clipping.h"
#include "render/transfer/polygon_extent.h"

namespace lumi {
namespace {

using Corners = std::vector<Eigen::Vector2d>;
using Box = Eigen::AlignedBox2d;

/// Affine errors are not chased further than this.
constexpr double kSmallest_px = 4.0;
/// Nor where photographs end that have nearly all weight further than this.
constexpr double kSmallestEnding_px = 16.0;

/// Added to weights, so that there are always some.
constexpr float kNoWeight = 1e-12F;
/// So far beyond its border a photograph counts nothing (uploaded_lumigraph.h).
constexpr double kBeyond_px = 1.0;

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void extend(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// The relative error of linear interpolation between homogeneous values in this range.
    [[nodiscard]] double half_spread() const { return 0.5 * (high - low) / (high + low); }
};

/// True when no corner's photograph pixel can be seen: all lie beyond the same border.
bool is_beyond(const Corners& corners, const PlaneView& view) {
    Box pixels;
    for (const Eigen::Vector2d& corner : corners)
        pixels.extend((view.view_from_eye * corner.homogeneous()).eval().hnormalized().eval());
    return pixels.max().x() < -kBeyond_px || pixels.max().y() < -kBeyond_px ||
           pixels.min().x() > view.width_px + kBeyond_px ||
           pixels.min().y() > view.height_px + kBeyond_px;
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

    void cut() { cut_where_behind(polygon_.corners_px, {}, 0); }

 private:
    /// Which of the three photographs can be seen on a piece.
    using Visible = std::array<bool, 3>;

    /// Splits a piece where it comes to lie behind view `k` and those after it.
    void cut_where_behind(const Corners& corners, Visible visible, std::size_t k) {
        if (corners.size() < 3) return;
        if (k == 3) return cut_by_error(corners, visible);
        visible[k] = false;
        if (polygon_.side_lines[k].isZero(0)) return cut_where_behind(corners, visible, k + 1);
        const PlaneView& view = views_[static_cast<std::size_t>(polygon_.view_indices[k])];
        const Eigen::Vector3d before =
            view.view_from_eye.row(2).transpose() - kLeastDepthRatio * Eigen::Vector3d::UnitZ();
        cut_where_behind(clipped(corners, -before), visible, k + 1);
        visible[k] = true;
        cut_where_behind(clipped(corners, before), visible, k + 1);
    }

    void cut_by_error(const Corners& corners, Visible visible) {
        if (corners.size() < 3) return;
        for (std::size_t k = 0; k < 3; ++k)
            visible[k] =
                visible[k] &&
                !is_beyond(corners, views_[static_cast<std::size_t>(polygon_.view_indices[k])]);
        if (visible == Visible{}) return;
        std::vector<BlendVertex> vertices = vertices_of(corners, visible);
        const bool may_lose = may_leave_too_little(vertices, visible);
        if (!may_lose && is_affine(vertices, visible))
            return keep_affine(centred(std::move(vertices), visible));
        const Box box = bounding_box(corners);
        const Eigen::Vector2d size = box.sizes();
        if (size.maxCoeff() <= (may_lose ? kSmallestEnding_px : kSmallest_px))
            return keep_exact(corners);
        const Eigen::Vector2d middle = box.center();
        const bool wide = size.x() >= size.y();
        const Eigen::Vector3d line(wide ? 1 : 0, wide ? 0 : 1, wide ? -middle.x() : -middle.y());
        cut_by_error(clipped(corners, line), visible);
        cut_by_error(clipped(corners, -line), visible);
    }

    void keep_exact(const Corners& corners) const {
        exact_.push_back(polygon_);
        exact_.back().corners_px = corners;
    }

    /// Weights of photographs that see nothing of the piece are 0. The depth is that for which the
    /// weighted mean of the others is affine: those that count most are nearly so themselves.
    [[nodiscard]] std::vector<BlendVertex> vertices_of(const Corners& corners,
                                                       const Visible& visible) const {
        std::vector<BlendVertex> vertices;
        for (const Eigen::Vector2d& corner : corners) {
            BlendVertex& vertex = vertices.emplace_back();
            vertex.pixel = {static_cast<float>(corner.x()), static_cast<float>(corner.y())};
            for (std::size_t k = 0; k < 3; ++k) {
                const auto view = static_cast<std::size_t>(polygon_.view_indices[k]);
                vertex.view_layers[k] = static_cast<float>(view);
                if (!visible[k]) continue;
                const Eigen::Vector3d pixel = views_[view].view_from_eye * corner.homogeneous();
                vertex.view_pixels[k] = {static_cast<float>(pixel.x() / pixel.z()),
                                         static_cast<float>(pixel.y() / pixel.z())};
                vertex.depth_ratios[k] = static_cast<float>(pixel.z());
                vertex.weights[k] = static_cast<float>(
                    std::max(0.0, polygon_.side_lines[k].dot(corner.homogeneous())));
            }
            vertex.inverse_depth =
                static_cast<float>(std::max(0.0, plane_.dot(corner.homogeneous())));
            vertex.face_index = static_cast<float>(polygon_.face_index);
        }
        const std::array<float, 3> shares = mean_weights(vertices, visible);
        for (BlendVertex& vertex : vertices) {
            float ratio = 0.0F;
            for (std::size_t k = 0; k < 3; ++k) ratio += shares[k] * vertex.depth_ratios[k];
            vertex.depth = 1 / ratio;
        }
        return vertices;
    }

    /// Whether photograph k shows all of the piece, inside of its border by so much.
    [[nodiscard]] bool shows_all(const std::vector<BlendVertex>& vertices, std::size_t k,
                                 double border_px) const {
        const PlaneView& view = views_[static_cast<std::size_t>(polygon_.view_indices[k])];
        return std::all_of(vertices.begin(), vertices.end(), [&](const BlendVertex& vertex) {
            const Eigen::Vector2d pixel = vector_of(vertex.view_pixels[k]);
            return pixel.minCoeff() >= border_px && pixel.x() <= view.width_px - border_px &&
                   pixel.y() <= view.height_px - border_px;
        });
    }

    /// Whether one of the photographs ends within the piece: beyond its border the others count as
    /// much as it does elsewhere.
    [[nodiscard]] bool ends_within(const std::vector<BlendVertex>& vertices,
                                   const Visible& visible) const {
        for (std::size_t k = 0; k < 3; ++k)
            if (visible[k] && !shows_all(vertices, k, 0.0)) return true;
        return false;
    }

    /// Whether pixels of the piece may be left to a photograph that has next to no weight: unless
    /// all have more, or one that has shows all of it. Weights are still side products here.
    [[nodiscard]] bool may_leave_too_little(const std::vector<BlendVertex>& vertices,
                                            const Visible& visible) const {
        bool has_little = false;
        for (std::size_t k = 0; k < 3; ++k) {
            if (!visible[k]) continue;
            Range shares;
            for (const BlendVertex& vertex : vertices)
                shares.extend(static_cast<double>(weight_of_photograph(k, vertex)) /
                              sum_of_weights(vertex));
            const bool is_sure = shares.low >= kSureWeight;
            if (is_sure && shows_all(vertices, k, options_.unsure_border_px)) return false;
            if (!is_sure && shares.high > 0) has_little = true;
        }
        return has_little;
    }

    /// Their sum is 1; alike where no photograph has a weight.
    static std::array<float, 3> mean_weights(const std::vector<BlendVertex>& vertices,
                                             const Visible& visible) {
        std::array<float, 3> shares{};
        float sum = 0.0F;
        for (std::size_t k = 0; k < 3; ++k) {
            if (!visible[k]) continue;
            for (const BlendVertex& vertex : vertices)
                shares[k] +=
                    (vertex.weights[k] + kNoWeight) /
                    (vertex.weights[0] + vertex.weights[1] + vertex.weights[2] + 3 * kNoWeight);
            sum += shares[k];
        }
        for (float& share : shares) share /= sum;
        return shares;
    }

    /// Weights are still side products here.
    [[nodiscard]] bool is_affine(const std::vector<BlendVertex>& vertices,
                                 const Visible& visible) const {
        const bool may_count_alone = ends_within(vertices, visible);
        Range sums;
        for (const BlendVertex& vertex : vertices)
            sums.extend(sum_of_weights(vertex) * static_cast<double>(vertex.depth));
        if (!(sums.low > 0)) return false;
        for (std::size_t k = 0; k < 3; ++k) {
            if (!visible[k]) continue;
            Range weights;
            Range ratios;
            Box pixels;
            for (const BlendVertex& vertex : vertices) {
                weights.extend(static_cast<double>(vertex.weights[k]) / sum_of_weights(vertex));
                ratios.extend(vertex.depth_ratios[k] * vertex.depth);
                pixels.extend(Eigen::Vector2d(vertex.view_pixels[k][0], vertex.view_pixels[k][1]));
            }
            // Half as much either way as it would be one way (centred).
            const double error_px = 0.5 * pixels.diagonal().norm() * ratios.half_spread();
            if ((weights.high - weights.low) * sums.half_spread() > options_.max_weight_error ||
                (may_count_alone ? 1.0 : weights.high) * error_px > options_.max_error_px)
                return false;
        }
        return true;
    }

    /// Interpolated between corners, places are wrong to one side, the most halfway between two of
    /// them: moved by half of that they are wrong by half as much, at corners and halfway alike.
    [[nodiscard]] std::vector<BlendVertex> centred(std::vector<BlendVertex> vertices,
                                                   const Visible& visible) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (!visible[k]) continue;
            Eigen::Vector2f worst = Eigen::Vector2f::Zero();
            for (std::size_t i = 1; i < vertices.size(); ++i) {
                for (const std::size_t from : {std::size_t{0}, i - 1}) {
                    const Eigen::Vector2f off = off_halfway(vertices[from], vertices[i], k);
                    if (off.squaredNorm() > worst.squaredNorm()) worst = off;
                }
            }
            for (BlendVertex& vertex : vertices) {
                vertex.view_pixels[k][0] += 0.5F * worst.x();
                vertex.view_pixels[k][1] += 0.5F * worst.y();
            }
        }
        return vertices;
    }

    /// From where photograph k is looked up halfway between two corners to where it should be.
    [[nodiscard]] Eigen::Vector2f off_halfway(const BlendVertex& a, const BlendVertex& b,
                                              std::size_t k) const {
        const auto view = static_cast<std::size_t>(polygon_.view_indices[k]);
        const Eigen::Vector3d halfway(0.5 * static_cast<double>(a.pixel[0] + b.pixel[0]),
                                      0.5 * static_cast<double>(a.pixel[1] + b.pixel[1]), 1);
        // There the ends count by one over their depths.
        const float share_a = b.depth / (a.depth + b.depth);
        const Eigen::Vector2f interpolated =
            share_a * Eigen::Vector2f(a.view_pixels[k][0], a.view_pixels[k][1]) +
            (1 - share_a) * Eigen::Vector2f(b.view_pixels[k][0], b.view_pixels[k][1]);
        return (views_[view].view_from_eye * halfway).hnormalized().cast<float>() - interpolated;
    }

    static double sum_of_weights(const BlendVertex& vertex) {
        return static_cast<double>(vertex.weights[0] + vertex.weights[1] + vertex.weights[2]);
    }

    void keep_affine(std::vector<BlendVertex> vertices) const {
        const auto first = static_cast<std::uint32_t>(affine_.vertices.size());
        for (BlendVertex& vertex : vertices) {
            const auto sum = static_cast<float>(sum_of_weights(vertex));
            for (float& weight : vertex.weights) weight /= sum;
            affine_.vertices.push_back(vertex);
        }
        for (std::uint32_t i = 1; i + 1 < vertices.size(); ++i)
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
    PieceCutter(polygon, views, plane_inverse_depth, options, affine, exact).cut();
}

}  // namespace lumi
