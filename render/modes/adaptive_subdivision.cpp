#include "render/modes/adaptive_subdivision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Each round of relaxation multiplies the errors by this.
constexpr double kRelaxationStep = 1.5;
constexpr double kMostRelaxation = 1000.0;
/// Triangles with an altitude below this share of the shortest edge are whole: their long edge may
/// have no reason to be split where the others always have. Vertices lie on the edges of their
/// neighbours, so that no gap opens.
constexpr double kThinnest = 0.25;

/// The interpolation error at the middle of an edge.
double edge_error_px(const PatchSample& a, const PatchSample& b, const PatchSample& middle,
                     double weight_error_px) {
    // At the middle of the picture of an edge, its ends count by one over their depths.
    const double share_a = b.affine_depth / (a.affine_depth + b.affine_depth);
    const double share_b = 1 - share_a;
    double error_px = 0;
    double weight_error = std::abs(middle.opacity - (share_a * a.opacity + share_b * b.opacity));
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector2d between = share_a * a.view_pixels[k] + share_b * b.view_pixels[k];
        error_px += middle.weights[k] * (middle.view_pixels[k] - between).norm();
        weight_error = std::max(
            weight_error,
            std::abs(middle.weights[k] - (share_a * a.weights[k] + share_b * b.weights[k])));
    }
    return std::max(error_px, 2 * weight_error_px * weight_error);
}

class AdaptivePatch {
 public:
    AdaptivePatch(const FacePolygon& polygon, const DepthSearch& search,
                  const Eigen::Vector3d& scene_plane, const PatchSampler::Options& sampling,
                  const AdaptiveSubdivisionOptions& options)
        : options_(options),
          sampler_(polygon, search, scene_plane, sampling),
          vertices_(sampler_) {}

    /// Keeps what was sampled before: relaxed errors need a part of it.
    void subdivide(double relaxation) {
        relaxation_ = relaxation;
        leaves_.clear();
        for (std::uint32_t i = 1; i + 1 < vertices_.corner_count(); ++i) subdivide({0, i, i + 1});
    }

    [[nodiscard]] std::size_t triangle_count() const { return leaves_.size(); }
    void append_to(BlendTriangles& drawn) const {
        vertices_.append_to(drawn, leaves_, VertexDepth::kAffine);
    }

 private:
    void subdivide(const Triangle& triangle) {
        const auto [a, b, c] = triangle;
        if (altitude_px(triangle) < kThinnest * options_.min_edge_px) {
            leaves_.push_back(triangle);
            return;
        }
        const std::array<bool, 3> splits{is_split(a, b), is_split(b, c), is_split(c, a)};
        const int count = static_cast<int>(std::count(splits.begin(), splits.end(), true));
        if (count == 0) {
            leaves_.push_back(triangle);
        } else if (count == 3) {
            split_in_four(triangle);
        } else if (count == 1) {
            const auto edge = static_cast<std::size_t>(
                std::find(splits.begin(), splits.end(), true) - splits.begin());
            split_in_two(turned(triangle, edge));
        } else {
            const auto kept = static_cast<std::size_t>(
                std::find(splits.begin(), splits.end(), false) - splits.begin());
            split_in_three(turned(triangle, kept));
        }
    }

    /// The smallest: area over longest side.
    [[nodiscard]] double altitude_px(const Triangle& triangle) const {
        const auto [a, b, c] = triangle;
        const Eigen::Vector2d ab = vertices_[b].pixel - vertices_[a].pixel;
        const Eigen::Vector2d ac = vertices_[c].pixel - vertices_[a].pixel;
        const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
        return longest > 0 ? std::abs(ab.x() * ac.y() - ab.y() * ac.x()) / longest : 0.0;
    }

    static Triangle turned(const Triangle& triangle, std::size_t first) {
        return {triangle[first], triangle[(first + 1) % 3], triangle[(first + 2) % 3]};
    }

    void split_in_four(const Triangle& triangle) {
        const auto [a, b, c] = triangle;
        const std::uint32_t ab = vertices_.midpoint(a, b);
        const std::uint32_t bc = vertices_.midpoint(b, c);
        const std::uint32_t ca = vertices_.midpoint(c, a);
        subdivide({a, ab, ca});
        subdivide({ab, b, bc});
        subdivide({ca, bc, c});
        subdivide({ab, bc, ca});
    }

    /// The first edge is split.
    void split_in_two(const Triangle& triangle) {
        const auto [a, b, c] = triangle;
        const std::uint32_t ab = vertices_.midpoint(a, b);
        subdivide({a, ab, c});
        subdivide({ab, b, c});
    }

    /// The first edge is kept. The quadrilateral that is left is cut along its shorter diagonal.
    void split_in_three(const Triangle& triangle) {
        const auto [a, b, c] = triangle;
        const std::uint32_t bc = vertices_.midpoint(b, c);
        const std::uint32_t ca = vertices_.midpoint(c, a);
        subdivide({ca, bc, c});
        if (vertices_.length_px(a, bc) < vertices_.length_px(b, ca)) {
            subdivide({a, b, bc});
            subdivide({a, bc, ca});
        } else {
            subdivide({a, b, ca});
            subdivide({b, bc, ca});
        }
    }

    [[nodiscard]] bool is_split(std::uint32_t a, std::uint32_t b) {
        const double length_px = vertices_.length_px(a, b);
        if (length_px > options_.max_edge_px) return true;
        if (length_px <= options_.min_edge_px * std::sqrt(relaxation_)) return false;
        const std::uint32_t middle = vertices_.midpoint(a, b);
        return edge_error_px(vertices_[a], vertices_[b], vertices_[middle],
                             options_.weight_error_px) > options_.max_error_px * relaxation_;
    }

    const AdaptiveSubdivisionOptions& options_;
    double relaxation_ = 1.0;
    PatchSampler sampler_;
    SubdividedPatch vertices_;
    std::vector<Triangle> leaves_;
};

}  // namespace

AdaptiveSubdivision adaptive_subdivision(const std::vector<FacePolygon>& polygons,
                                         const DepthSearch& search,
                                         const Eigen::Vector3d& scene_plane,
                                         const PatchSampler::Options& sampling,
                                         const AdaptiveSubdivisionOptions& options) {
    std::vector<std::unique_ptr<AdaptivePatch>> patches(polygons.size());
    AdaptiveSubdivision result;
    for (; result.relaxation < kMostRelaxation; result.relaxation *= kRelaxationStep) {
        parallel_for(static_cast<int>(polygons.size()), 0, [&](int i) {
            auto& patch = patches[static_cast<std::size_t>(i)];
            if (!patch)
                patch = std::make_unique<AdaptivePatch>(polygons[static_cast<std::size_t>(i)],
                                                        search, scene_plane, sampling, options);
            patch->subdivide(result.relaxation);
        });
        std::size_t count = 0;
        for (const auto& patch : patches) count += patch->triangle_count();
        if (options.max_triangles == 0 || count <= options.max_triangles) break;
    }
    for (const auto& patch : patches) patch->append_to(result.triangles);
    return result;
}

}  // namespace lumi
