#include "render/modes/adaptive_subdivision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "calib/work/parallel_for.h"
#include "render/modes/edge_table.h"
#include "render/modes/relaxation_search.h"

namespace lumi {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr std::uint32_t kNone = 0xffffffffU;
/// Triangles with an altitude below this share of the shortest edge are whole: their long edge may
/// have no reason to be split where the others always have. Vertices lie on the edges of their
/// neighbours, so that no gap opens.
constexpr double kThinnest = 0.25;
/// Vertices that one thread looks up at a time; it takes so long that starting it does not count.
constexpr std::size_t kVerticesAtATime = 128;

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

/// How far errors may be relaxed until an edge is whole whose error and length are so many times
/// those that are allowed. Relaxed errors leave edges longer, by the root; where errors are large
/// they are shorter, so that not all edges of one length are given up at once.
double greatest_relaxation(double error, double length) {
    constexpr double kLargeError = 64.0;
    constexpr double kLeastShare = 0.25;
    const double share = std::clamp(std::cbrt(error / kLargeError), kLeastShare, 1.0);
    return std::min(error, 1 + (length * length - 1) * share);
}

/// The edges of a triangle, each after the corner that it starts from.
using TriangleEdges = std::array<std::uint32_t, 3>;

}  // namespace

/// The polygons of one picture as triangles, level by level: all triangles of a level are split, or
/// not, before any of the next, so that what is to be looked up for them is looked up at once.
class AdaptiveSubdivider::Mesh {
 public:
    void begin(const std::vector<FacePolygon>& polygons, const DepthSearch& search,
               const Eigen::Vector3d& scene_plane, const PatchSampler::Options& sampling,
               const AdaptiveSubdivisionOptions& options) {
        options_ = options;
        samplers_.clear();
        polygon_of_.clear();
        samples_.clear();
        edge_numbers_.clear();
        edges_.clear();
        roots_.clear();
        whole_.clear();
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            samplers_.emplace_back(polygons[i], search, scene_plane, sampling);
            const auto first = static_cast<std::uint32_t>(samples_.size());
            for (const Eigen::Vector2d& corner : polygons[i].corners_px) {
                samples_.push_back(samplers_.back().at(corner));
                polygon_of_.push_back(static_cast<std::uint32_t>(i));
            }
            for (std::uint32_t k = first + 1; k + 1 < samples_.size(); ++k)
                roots_.push_back({first, k, k + 1});
        }
    }

    /// The number of triangles with errors relaxed so much; nothing, and what was found before
    /// stays, where they are more than `most`.
    [[nodiscard]] std::optional<std::size_t> subdivide(double relaxation, std::size_t most) {
        least_edge_px_ = options_.min_edge_px * std::sqrt(relaxation);
        leaves_.clear();
        level_ = roots_;
        while (!level_.empty()) {
            look_up_edges();
            next_level_.clear();
            for (std::size_t i = 0; i < level_.size(); ++i)
                split(level_[i], edges_of_level_[i], relaxation);
            level_.swap(next_level_);
            if (leaves_.size() + level_.size() > most) return std::nullopt;
        }
        whole_.swap(leaves_);
        return whole_.size();
    }

    /// The triangles that were found last, and the vertices that they name.
    [[nodiscard]] BlendTriangles triangles() const {
        BlendTriangles drawn;
        drawn.indices.reserve(3 * whole_.size());
        drawn.vertices.reserve(whole_.size());
        std::vector<std::uint32_t> index_of(samples_.size(), kNone);
        for (const Triangle& triangle : whole_) {
            for (const std::uint32_t vertex : triangle) {
                if (index_of[vertex] == kNone) {
                    index_of[vertex] = static_cast<std::uint32_t>(drawn.vertices.size());
                    drawn.vertices.push_back(blend_vertex(samples_[vertex],
                                                          samplers_[polygon_of_[vertex]].polygon(),
                                                          VertexDepth::kAffine));
                }
                drawn.indices.push_back(index_of[vertex]);
            }
        }
        return drawn;
    }

 private:
    struct Edge {
        std::uint32_t from;
        std::uint32_t to;
        double length_px;
        std::uint32_t middle = kNone;  ///< A vertex, when it was looked up.
        double split_below = 0.0;      ///< It is split where errors are relaxed less.
    };

    [[nodiscard]] std::uint32_t edge_between(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t number = edge_numbers_.number_of(a, b);
        if (number == edges_.size())
            edges_.push_back({a, b, (samples_[a].pixel - samples_[b].pixel).norm()});
        return number;
    }

    /// Looks up the middles of the level's edges that might be split.
    void look_up_edges() {
        edges_of_level_.clear();
        wanted_.clear();
        for (const Triangle& triangle : level_) {
            TriangleEdges& edges = edges_of_level_.emplace_back();
            for (std::size_t i = 0; i < 3; ++i)
                edges[i] = edge_between(triangle[i], triangle[(i + 1) % 3]);
            if (is_thin(triangle, edges)) continue;
            for (const std::uint32_t number : edges) want_middle(number);
        }
        samples_.resize(polygon_of_.size());
        const std::size_t blocks = (wanted_.size() + kVerticesAtATime - 1) / kVerticesAtATime;
        parallel_for(static_cast<int>(blocks), 0, [&](int block) {
            const std::size_t first = static_cast<std::size_t>(block) * kVerticesAtATime;
            const std::size_t end = std::min(first + kVerticesAtATime, wanted_.size());
            for (std::size_t i = first; i < end; ++i) look_up(edges_[wanted_[i]]);
        });
    }

    void want_middle(std::uint32_t number) {
        Edge& edge = edges_[number];
        const bool is_short = edge.length_px <= std::min(least_edge_px_, options_.max_edge_px);
        if (edge.middle != kNone || is_short) return;
        edge.middle = static_cast<std::uint32_t>(polygon_of_.size());
        polygon_of_.push_back(polygon_of_[edge.from]);
        wanted_.push_back(number);
    }

    void look_up(Edge& edge) {
        const PatchSample& a = samples_[edge.from];
        const PatchSample& b = samples_[edge.to];
        PatchSample& middle = samples_[edge.middle];
        middle = samplers_[polygon_of_[edge.middle]].at(0.5 * (a.pixel + b.pixel));
        edge.split_below = greatest_relaxation(
            edge_error_px(a, b, middle, options_.weight_error_px) / options_.max_error_px,
            edge.length_px / options_.min_edge_px);
    }

    [[nodiscard]] bool is_split(std::uint32_t number, double relaxation) const {
        const Edge& edge = edges_[number];
        if (edge.length_px > options_.max_edge_px) return true;
        return edge.length_px > least_edge_px_ && edge.split_below > relaxation;
    }

    /// By its smallest altitude: area over longest side.
    [[nodiscard]] bool is_thin(const Triangle& triangle, const TriangleEdges& edges) const {
        const Eigen::Vector2d ab = samples_[triangle[1]].pixel - samples_[triangle[0]].pixel;
        const Eigen::Vector2d ac = samples_[triangle[2]].pixel - samples_[triangle[0]].pixel;
        const double longest = std::max(
            {edges_[edges[0]].length_px, edges_[edges[1]].length_px, edges_[edges[2]].length_px});
        return std::abs(ab.x() * ac.y() - ab.y() * ac.x()) <
               kThinnest * options_.min_edge_px * longest;
    }

    void split(const Triangle& triangle, const TriangleEdges& edges, double relaxation) {
        std::array<bool, 3> splits{};
        if (!is_thin(triangle, edges))
            for (std::size_t i = 0; i < 3; ++i) splits[i] = is_split(edges[i], relaxation);
        const int count = static_cast<int>(std::count(splits.begin(), splits.end(), true));
        if (count == 0) {
            leaves_.push_back(triangle);
            return;
        }
        // So that the first edge is the only one that is split, or the only one that is not.
        const bool odd = count == 1;
        const auto first =
            static_cast<std::size_t>(std::find(splits.begin(), splits.end(), odd) - splits.begin());
        const std::size_t turn = count == 3 ? 0 : first;
        const std::array<std::uint32_t, 3> corners{triangle[turn], triangle[(turn + 1) % 3],
                                                   triangle[(turn + 2) % 3]};
        const std::array<std::uint32_t, 3> middles{edges_[edges[turn]].middle,
                                                   edges_[edges[(turn + 1) % 3]].middle,
                                                   edges_[edges[(turn + 2) % 3]].middle};
        if (count == 1) return split_in_two(corners, middles);
        if (count == 2) return split_in_three(corners, middles);
        split_in_four(corners, middles);
    }

    void split_in_four(const Triangle& corners, const Triangle& middles) {
        const auto [a, b, c] = corners;
        const auto [ab, bc, ca] = middles;
        next_level_.insert(next_level_.end(),
                           {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }

    /// The first edge is split.
    void split_in_two(const Triangle& corners, const Triangle& middles) {
        const auto [a, b, c] = corners;
        next_level_.insert(next_level_.end(), {{a, middles[0], c}, {middles[0], b, c}});
    }

    /// The first edge is kept. The quadrilateral that is left is cut along its shorter diagonal.
    void split_in_three(const Triangle& corners, const Triangle& middles) {
        const auto [a, b, c] = corners;
        const std::uint32_t bc = middles[1];
        const std::uint32_t ca = middles[2];
        next_level_.push_back({ca, bc, c});
        const auto squared_length = [&](std::uint32_t from, std::uint32_t to) {
            return (samples_[from].pixel - samples_[to].pixel).squaredNorm();
        };
        if (squared_length(a, bc) < squared_length(b, ca)) {
            next_level_.insert(next_level_.end(), {{a, b, bc}, {a, bc, ca}});
        } else {
            next_level_.insert(next_level_.end(), {{a, b, ca}, {b, bc, ca}});
        }
    }

    AdaptiveSubdivisionOptions options_;
    double least_edge_px_ = 0.0;             ///< Shorter ones are not split.
    std::vector<PatchSampler> samplers_;     ///< One a polygon.
    std::vector<std::uint32_t> polygon_of_;  ///< Of each vertex.
    std::vector<PatchSample> samples_;       ///< The vertices.
    EdgeTable edge_numbers_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> wanted_;  ///< Edges whose middles are to be looked up.
    std::vector<Triangle> roots_;
    std::vector<Triangle> level_;
    std::vector<TriangleEdges> edges_of_level_;
    std::vector<Triangle> next_level_;
    std::vector<Triangle> leaves_;
    std::vector<Triangle> whole_;
};

AdaptiveSubdivider::AdaptiveSubdivider() : mesh_(std::make_unique<Mesh>()) {}
AdaptiveSubdivider::~AdaptiveSubdivider() = default;
AdaptiveSubdivider::AdaptiveSubdivider(AdaptiveSubdivider&&) noexcept = default;
AdaptiveSubdivider& AdaptiveSubdivider::operator=(AdaptiveSubdivider&&) noexcept = default;

AdaptiveSubdivision AdaptiveSubdivider::subdivide(const std::vector<FacePolygon>& polygons,
                                                  const DepthSearch& search,
                                                  const Eigen::Vector3d& scene_plane,
                                                  const PatchSampler::Options& sampling,
                                                  const AdaptiveSubdivisionOptions& options) {
    mesh_->begin(polygons, search, scene_plane, sampling, options);
    AdaptiveSubdivision result;
    result.relaxation = least_relaxation(
        options.max_triangles,
        [&](double relaxation, std::size_t most) { return mesh_->subdivide(relaxation, most); });
    result.triangles = mesh_->triangles();
    return result;
}

AdaptiveSubdivision adaptive_subdivision(const std::vector<FacePolygon>& polygons,
                                         const DepthSearch& search,
                                         const Eigen::Vector3d& scene_plane,
                                         const PatchSampler::Options& sampling,
                                         const AdaptiveSubdivisionOptions& options) {
    return AdaptiveSubdivider().subdivide(polygons, search, scene_plane, sampling, options);
}

}  // namespace lumi
