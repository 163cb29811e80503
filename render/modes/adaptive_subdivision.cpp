#include "render/modes/adaptive_subdivision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "calib/work/parallel_for.h"
#include "render/modes/relaxation_search.h"
#include "render/modes/split_edges.h"

namespace lumi {
namespace {

constexpr std::uint32_t kNone = SplitEdge::kNone;
/// Triangles with an altitude below this share of the shortest edge are whole: their long edge may
/// have no reason to be split where the others always have. Vertices lie on the edges of their
/// neighbours, so that no gap opens.
constexpr double kThinnest = 0.25;
/// Vertices that one thread looks up at a time; it takes so long that starting it hardly counts.
constexpr std::size_t kVerticesAtATime = 32;
constexpr std::size_t kEdgesAtATime = 256;

/// Corners, and the edges that start from them.
struct Triangle {
    std::array<std::uint32_t, 3> corners{};
    std::array<std::uint32_t, 3> edges{};
    /// All that it lies in are split in four, and so they are for lesser relaxations.
    bool is_settled = false;
};

}  // namespace

/// The polygons of one picture as triangles, level by level: all triangles of a level are split, or
/// not, before any of the next, so that what is to be looked up for them is looked up at once.
class AdaptiveSubdivider::Mesh {
 public:
    void begin(const std::vector<FacePolygon>& polygons, const DepthSearch& search,
               const Eigen::Vector3d& scene_plane, const PatchSampler::Options& sampling,
               const AdaptiveSubdivisionOptions& options) {
        options_ = options;
        if (!search.has_depth()) options_.counts.guess_ratio = 1.0;
        max_edge_px_ = static_cast<float>(options.max_edge_px);
        samplers_.clear();
        polygon_of_.clear();
        pixels_.clear();
        vertices_.clear();
        edges_.clear();
        unjudged_.clear();
        settled_.clear();
        whole_.clear();
        for (const FacePolygon& polygon : polygons) {
            samplers_.emplace_back(polygon, search, scene_plane, sampling);
            const auto first = static_cast<std::uint32_t>(pixels_.size());
            for (const Eigen::Vector2d& corner : polygon.corners_px)
                add_vertex(corner, static_cast<std::uint32_t>(samplers_.size() - 1));
            for (std::uint32_t k = first + 1; k + 1 < pixels_.size(); ++k)
                settled_.push_back(triangle_of(first, k, k + 1, true));
        }
    }

    /// The number of triangles with errors relaxed so much; nothing, and what was found before
    /// stays, where they are more than `most`. To be called for lesser and lesser relaxations once
    /// it gave a number.
    [[nodiscard]] std::optional<std::size_t> subdivide(float relaxation, std::size_t most) {
        least_edge_px_ = static_cast<float>(options_.min_edge_px) * std::sqrt(relaxation);
        leaves_.clear();
        now_settled_.clear();
        level_ = settled_;
        while (!level_.empty()) {
            next_level_.clear();
            undecided_.clear();
            for (const Triangle& triangle : level_) split_or_wait(triangle, relaxation);
            if (!undecided_.empty()) look_up_new();
            for (const Triangle& triangle : undecided_) split(triangle, relaxation);
            level_.swap(next_level_);
            if (leaves_.size() + level_.size() > most) return std::nullopt;
        }
        look_up_new();
        whole_.swap(leaves_);
        settled_.swap(now_settled_);
        return whole_.size();
    }

    /// The triangles that were found last, and the vertices that they name.
    [[nodiscard]] BlendTriangles triangles() const {
        BlendTriangles drawn;
        drawn.indices.reserve(3 * whole_.size());
        drawn.vertices.reserve(whole_.size());
        std::vector<std::uint32_t> index_of(vertices_.size(), kNone);
        for (const Triangle& triangle : whole_) {
            for (const std::uint32_t corner : triangle.corners) {
                if (index_of[corner] == kNone) {
                    index_of[corner] = static_cast<std::uint32_t>(drawn.vertices.size());
                    drawn.vertices.push_back(vertices_[corner]);
                }
                drawn.indices.push_back(index_of[corner]);
            }
        }
        return drawn;
    }

 private:
    /// To be looked up.
    void add_vertex(const Eigen::Vector2d& pixel, std::uint32_t polygon) {
        pixels_.push_back(pixel);
        polygon_of_.push_back(polygon);
    }

    [[nodiscard]] std::uint32_t inner_edge(std::uint32_t a, std::uint32_t b) {
        return edges_.within(a, b, pixels_);
    }
    [[nodiscard]] std::uint32_t half_at(std::uint32_t edge, std::uint32_t corner) {
        return edges_.half_at(edge, corner, pixels_);
    }

    [[nodiscard]] Triangle triangle_of(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                       bool is_settled) {
        return {{a, b, c}, {inner_edge(a, b), inner_edge(b, c), inner_edge(c, a)}, is_settled};
    }

    /// Splits a triangle, or leaves it whole, if what is known of its edges tells.
    void split_or_wait(const Triangle& triangle, float relaxation) {
        if (is_thin(triangle)) return leave_whole(triangle);
        bool is_decided = true;
        for (const std::uint32_t edge : triangle.edges)
            if (!knows_enough_of(edge)) is_decided = false;
        if (is_decided) {
            split(triangle, relaxation);
        } else {
            undecided_.push_back(triangle);
        }
    }

    /// False while the middle of an edge that might be split is still to be looked up. Of an edge
    /// that is split in any case nothing needs to be known.
    [[nodiscard]] bool knows_enough_of(std::uint32_t number) {
        SplitEdge& edge = edges_[number];
        if (edge.middle != kNone)
            return edge.middle < vertices_.size() || edge.length_px > max_edge_px_;
        if (edge.length_px <= std::min(least_edge_px_, max_edge_px_)) return true;
        edge.middle = static_cast<std::uint32_t>(pixels_.size());
        add_vertex(0.5 * (pixels_[edge.from] + pixels_[edge.to]), polygon_of_[edge.from]);
        if (edge.length_px > max_edge_px_) return true;
        unjudged_.push_back(number);
        return false;
    }

    /// All vertices that were added, and then the edges whose middles they are.
    void look_up_new() {
        const std::size_t known = vertices_.size();
        vertices_.resize(pixels_.size());
        parallel_for_runs(vertices_.size() - known, kVerticesAtATime, 0,
                          [&](std::size_t first, std::size_t end) {
                              for (std::size_t i = first; i < end; ++i) look_up(known + i);
                          });
        parallel_for_runs(unjudged_.size(), kEdgesAtATime, 0,
                          [&](std::size_t first, std::size_t end) {
                              for (std::size_t i = first; i < end; ++i) judge(edges_[unjudged_[i]]);
                          });
        unjudged_.clear();
    }

    void look_up(std::size_t vertex) {
        const PatchSampler& sampler = samplers_[polygon_of_[vertex]];
        vertices_[vertex] =
            blend_vertex(sampler.at(pixels_[vertex]), sampler.polygon(), VertexDepth::kAffine);
    }

    /// How far errors may be relaxed for the edge to be split.
    void judge(SplitEdge& edge) const {
        const BlendVertex& middle = vertices_[edge.middle];
        const BlendVertex& from = vertices_[edge.from];
        const BlendVertex& to = vertices_[edge.to];
        const double allowed_px =
            edge_looseness(from, to, middle, options_.counts) * options_.min_edge_px;
        edge.split_below = static_cast<float>(greatest_relaxation(
            edge_error_px(from, to, middle, options_.counts) / options_.max_error_px,
            static_cast<double>(edge.length_px) / allowed_px));
    }

    [[nodiscard]] bool is_split(std::uint32_t number, float relaxation) const {
        const SplitEdge& edge = edges_[number];
        if (edge.length_px > max_edge_px_) return true;
        return edge.length_px > least_edge_px_ && edge.split_below > relaxation;
    }

    /// By its smallest altitude: area over longest side.
    [[nodiscard]] bool is_thin(const Triangle& triangle) const {
        const auto [a, b, c] = triangle.corners;
        const Eigen::Vector2d ab = pixels_[b] - pixels_[a];
        const Eigen::Vector2d ac = pixels_[c] - pixels_[a];
        float longest = 0;
        for (const std::uint32_t edge : triangle.edges)
            longest = std::max(longest, edges_[edge].length_px);
        return std::abs(ab.x() * ac.y() - ab.y() * ac.x()) <
               kThinnest * options_.min_edge_px * static_cast<double>(longest);
    }

    void leave_whole(const Triangle& triangle) {
        if (triangle.is_settled) now_settled_.push_back(triangle);
        leaves_.push_back(triangle);
    }

    void split(const Triangle& triangle, float relaxation) {
        std::array<bool, 3> splits{};
        for (std::size_t i = 0; i < 3; ++i) splits[i] = is_split(triangle.edges[i], relaxation);
        const auto count = std::count(splits.begin(), splits.end(), true);
        if (count == 0) return leave_whole(triangle);
        if (count == 3) return split_in_four(triangle);
        if (triangle.is_settled) now_settled_.push_back(triangle);
        if (count == 1) return split_in_two(turned_to(true, splits, triangle));
        split_in_three(turned_to(false, splits, triangle));
    }

    /// So that the first edge is the one that is split, or is not.
    static Triangle turned_to(bool is_split, const std::array<bool, 3>& splits,
                              const Triangle& triangle) {
        Triangle turned = triangle;
        const auto first = std::find(splits.begin(), splits.end(), is_split) - splits.begin();
        std::rotate(turned.corners.begin(), turned.corners.begin() + first, turned.corners.end());
        std::rotate(turned.edges.begin(), turned.edges.begin() + first, turned.edges.end());
        return turned;
    }

    void split_in_four(const Triangle& triangle) {
        const auto [a, b, c] = triangle.corners;
        const auto [edge_ab, edge_bc, edge_ca] = triangle.edges;
        const std::uint32_t ab = edges_[edge_ab].middle;
        const std::uint32_t bc = edges_[edge_bc].middle;
        const std::uint32_t ca = edges_[edge_ca].middle;
        const Triangle inner = triangle_of(ab, bc, ca, triangle.is_settled);
        const bool settled = triangle.is_settled;
        const auto [beside_b, beside_c, beside_a] = inner.edges;
        next_level_.push_back(
            {{a, ab, ca}, {half_at(edge_ab, a), beside_a, half_at(edge_ca, a)}, settled});
        next_level_.push_back(
            {{ab, b, bc}, {half_at(edge_ab, b), half_at(edge_bc, b), beside_b}, settled});
        next_level_.push_back(
            {{ca, bc, c}, {beside_c, half_at(edge_bc, c), half_at(edge_ca, c)}, settled});
        next_level_.push_back(inner);
    }

    /// The first edge is split.
    void split_in_two(const Triangle& triangle) {
        const auto [a, b, c] = triangle.corners;
        const auto [edge_ab, edge_bc, edge_ca] = triangle.edges;
        const std::uint32_t ab = edges_[edge_ab].middle;
        const std::uint32_t across = inner_edge(ab, c);
        next_level_.push_back({{a, ab, c}, {half_at(edge_ab, a), across, edge_ca}});
        next_level_.push_back({{ab, b, c}, {half_at(edge_ab, b), edge_bc, across}});
    }

    /// The first edge is kept. The quadrilateral that is left is cut along its shorter diagonal.
    void split_in_three(const Triangle& triangle) {
        const auto [a, b, c] = triangle.corners;
        const auto [edge_ab, edge_bc, edge_ca] = triangle.edges;
        const std::uint32_t bc = edges_[edge_bc].middle;
        const std::uint32_t ca = edges_[edge_ca].middle;
        const std::uint32_t opposite = inner_edge(ca, bc);
        const std::uint32_t at_a = half_at(edge_ca, a);
        const std::uint32_t at_b = half_at(edge_bc, b);
        next_level_.push_back({{ca, bc, c}, {opposite, half_at(edge_bc, c), half_at(edge_ca, c)}});
        if ((pixels_[a] - pixels_[bc]).squaredNorm() < (pixels_[b] - pixels_[ca]).squaredNorm()) {
            const std::uint32_t diagonal = inner_edge(a, bc);
            next_level_.push_back({{a, b, bc}, {edge_ab, at_b, diagonal}});
            next_level_.push_back({{a, bc, ca}, {diagonal, opposite, at_a}});
        } else {
            const std::uint32_t diagonal = inner_edge(b, ca);
            next_level_.push_back({{a, b, ca}, {edge_ab, diagonal, at_a}});
            next_level_.push_back({{b, bc, ca}, {at_b, opposite, diagonal}});
        }
    }

    AdaptiveSubdivisionOptions options_;
    float least_edge_px_ = 0.0F;             ///< Shorter ones are not split.
    float max_edge_px_ = 0.0F;               ///< Longer ones are, in any case.
    std::vector<PatchSampler> samplers_;     ///< One a polygon.
    std::vector<std::uint32_t> polygon_of_;  ///< Of each vertex.
    std::vector<Eigen::Vector2d> pixels_;    ///< The same.
    std::vector<BlendVertex> vertices_;      ///< The same, as far as they are looked up.
    SplitEdges edges_;
    std::vector<std::uint32_t> unjudged_;  ///< Edges whose middles are to be looked up.
    /// Where the next subdivision begins: of what is not split in four the largest triangles.
    std::vector<Triangle> settled_;
    std::vector<Triangle> now_settled_;
    std::vector<Triangle> level_;
    std::vector<Triangle> undecided_;  ///< Of the level, until their edges are looked up.
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
    result.relaxation =
        least_relaxation(options.max_triangles, [&](double relaxation, std::size_t most) {
            return mesh_->subdivide(static_cast<float>(relaxation), most);
        });
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
