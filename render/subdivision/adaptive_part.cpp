#include "render/subdivision/adaptive_part.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace lumi {
namespace {

constexpr std::uint32_t kNone = SplitEdge::kNone;

/// Room for so many vertices, and as many edges: what grew with the eye's way would go on growing
/// for minutes.
constexpr std::size_t kFirstVertices = std::size_t{1} << 12;

/// So many times as long as those that are not split: what shorter ones miss costs more triangles
/// than it is worth.
constexpr double kLongEdges = 3.0;

}  // namespace

AdaptivePart::AdaptivePart() {
    polygon_of_.reserve(kFirstVertices);
    pixels_.reserve(kFirstVertices);
    vertices_.reserve(kFirstVertices);
    edges_.reserve(kFirstVertices);
}

void AdaptivePart::begin(const CoarseTriangles& coarse, std::size_t first, std::size_t end,
                         const std::vector<PatchSampler>& samplers, const OutlineCells& outlines,
                         const AdaptiveSubdivisionOptions& options) {
    options_ = options;
    samplers_ = &samplers;
    outlines_ = &outlines;
    max_edge_px_ = static_cast<float>(options.max_edge_px);
    polygon_of_.clear();
    pixels_.clear();
    vertices_.clear();
    edges_.clear();
    unjudged_.clear();
    settled_.clear();
    whole_.clear();
    std::vector<std::uint32_t> vertex_of(coarse.pixels.size(), kNone);
    for (std::size_t i = first; i < end; ++i) {
        const auto& [corners, polygon] = coarse.triangles[i];
        for (const std::uint32_t corner : corners) {
            if (vertex_of[corner] != kNone) continue;
            vertex_of[corner] = static_cast<std::uint32_t>(pixels_.size());
            add_vertex(coarse.pixels[corner], polygon);
        }
        settled_.push_back(
            triangle_of(vertex_of[corners[0]], vertex_of[corners[1]], vertex_of[corners[2]], true));
        for (const std::uint32_t edge : settled_.back().edges)
            edges_[edge].is_border = !edges_[edge].is_border;  // Two triangles have it, or one.
    }
}

void AdaptivePart::subdivide(float relaxation, std::size_t most, std::atomic<std::size_t>& count) {
    least_edge_px_ = static_cast<float>(options_.min_edge_px) * std::sqrt(relaxation);
    leaves_.clear();
    now_settled_.clear();
    thin_.clear();
    level_ = settled_;
    std::size_t counted = 0;
    while (!level_.empty()) {
        next_level_.clear();
        undecided_.clear();
        for (const Triangle& triangle : level_) split_or_wait(triangle, relaxation);
        if (!undecided_.empty()) look_up_new();
        for (const Triangle& triangle : undecided_) split(triangle, relaxation);
        level_.swap(next_level_);
        const std::size_t more = leaves_.size() + thin_.size() + level_.size() - counted;
        counted += more;
        if (count.fetch_add(more) + more > most) return;
    }
    look_up_borders_of_thin(relaxation);
    for (const Triangle& triangle : thin_)
        split_where_neighbours_did(triangle, {true, true, true}, relaxation);
    look_up_new();
    pieces_.clear();
    for (const Triangle& leaf : leaves_) {
        cut_at_outlines(leaf);
        if (pieces_.size() <= counted) continue;
        const std::size_t more = pieces_.size() - counted;
        counted += more;
        if (count.fetch_add(more) + more > most) return;
    }
}

void AdaptivePart::keep() {
    whole_.swap(pieces_);
    settled_.swap(now_settled_);
}

void AdaptivePart::append_to(BlendTriangles& drawn) const {
    std::vector<std::uint32_t> index_of(vertices_.size(), kNone);
    for (const Corners& corners : whole_) {
        for (const std::uint32_t corner : corners) {
            if (index_of[corner] == kNone) {
                index_of[corner] = static_cast<std::uint32_t>(drawn.vertices.size());
                drawn.vertices.push_back(vertices_[corner]);
            }
            drawn.indices.push_back(index_of[corner]);
        }
    }
}

/// To be looked up.
void AdaptivePart::add_vertex(const Eigen::Vector2d& pixel, std::uint32_t polygon) {
    pixels_.push_back(pixel);
    polygon_of_.push_back(polygon);
}

std::uint32_t AdaptivePart::inner_edge(std::uint32_t a, std::uint32_t b) {
    return edges_.within(a, b, pixels_);
}

std::uint32_t AdaptivePart::half_at(std::uint32_t edge, std::uint32_t corner) {
    return edges_.half_at(edge, corner, pixels_);
}

AdaptivePart::Triangle AdaptivePart::triangle_of(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                                 bool is_settled) {
    return {{a, b, c}, {inner_edge(a, b), inner_edge(b, c), inner_edge(c, a)}, is_settled};
}

/// Splits a triangle, or leaves it whole, if what is known of its edges tells.
void AdaptivePart::split_or_wait(const Triangle& triangle, float relaxation) {
    if (is_left_whole(triangle)) {
        if (triangle.is_settled) now_settled_.push_back(triangle);
        return thin_.push_back(triangle);
    }
    bool is_decided = true;
    for (const std::uint32_t edge : triangle.edges)
        if (!knows_enough_of(edge)) is_decided = false;
    if (is_decided) {
        split(triangle, relaxation);
    } else {
        undecided_.push_back(triangle);
    }
}

/// False while the middle of an edge that might be split is still to be looked up. Of an edge that
/// is split in any case nothing needs to be known.
bool AdaptivePart::knows_enough_of(std::uint32_t number) {
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
void AdaptivePart::look_up_new() {
    for (std::size_t i = vertices_.size(); i < pixels_.size(); ++i) {
        const PatchSampler& sampler = (*samplers_)[polygon_of_[i]];
        vertices_.push_back(
            blend_vertex(sampler.at(pixels_[i]), sampler.polygon(), VertexDepth::kAffine));
    }
    for (const std::uint32_t number : unjudged_) judge(edges_[number]);
    unjudged_.clear();
}

/// How far errors may be relaxed for the edge to be split.
void AdaptivePart::judge(SplitEdge& edge) const {
    const BlendVertex& middle = vertices_[edge.middle];
    const BlendVertex& from = vertices_[edge.from];
    const BlendVertex& to = vertices_[edge.to];
    const double allowed_px =
        edge_looseness(from, to, middle, options_.counts) * options_.min_edge_px;
    edge.split_below =
        static_cast<float>(greatest_relaxation(error_px_of(edge) / options_.max_error_px,
                                               static_cast<double>(edge.length_px) / allowed_px));
}

/// As its middle tells; of a long edge, beside which views know of an outline, what it may miss,
/// though all that was looked up along it is a guess: an outline was seen.
double AdaptivePart::error_px_of(const SplitEdge& edge) const {
    const double at_middle_px = edge_error_px(vertices_[edge.from], vertices_[edge.to],
                                              vertices_[edge.middle], options_.counts);
    const double step_px = kStepError_px;
    const double longest_px = kLongEdges * options_.min_edge_px;
    const bool is_long = static_cast<double>(edge.length_px) > longest_px;
    if (!is_long || at_middle_px >= step_px) return at_middle_px;
    return outlines_->has_beside(pixels_[edge.from], pixels_[edge.to]) ? step_px : at_middle_px;
}

bool AdaptivePart::is_split(std::uint32_t number, float relaxation) const {
    const SplitEdge& edge = edges_[number];
    if (edge.length_px > max_edge_px_) return true;
    return edge.length_px > least_edge_px_ && edge.split_below > relaxation;
}

/// Thin triangles are: their long edge may have no reason to be split where the others always have.
/// But a face that is seen along its plane is as thin, and crosses the whole picture: no photograph
/// shows all of it, so that it is cut to the length that any triangle may have, unless it covers
/// less than the smallest would.
bool AdaptivePart::is_left_whole(const Triangle& triangle) const {
    const auto [a, b, c] = triangle.corners;
    const float longest_px = edges_[triangle.edges[longest_edge_of(triangle)]].length_px;
    const Eigen::Vector2d ab = pixels_[b] - pixels_[a];
    const Eigen::Vector2d ac = pixels_[c] - pixels_[a];
    const double least_edge_px = options_.min_edge_px;
    return is_thin(ab, ac, longest_px, least_edge_px) &&
           (longest_px <= max_edge_px_ || doubled_area_px2(ab, ac) < least_edge_px * least_edge_px);
}

/// What tells where neighbours in other parts split the edges that they share with thin triangles.
/// Edges that are not looked up here no neighbour in this part splits.
void AdaptivePart::look_up_borders_of_thin(float relaxation) {
    std::vector<std::uint32_t> asked;
    for (const Triangle& triangle : thin_)
        std::copy_if(triangle.edges.begin(), triangle.edges.end(), std::back_inserter(asked),
                     [&](std::uint32_t edge) { return edges_[edge].is_border; });
    while (!asked.empty()) {
        for (const std::uint32_t edge : asked) static_cast<void>(knows_enough_of(edge));
        look_up_new();
        std::vector<std::uint32_t> halves;
        for (const std::uint32_t edge : asked) {
            if (!is_split(edge, relaxation)) continue;
            halves.push_back(half_at(edge, edges_[edge].from));
            halves.push_back(half_at(edge, edges_[edge].to));
        }
        asked.swap(halves);
    }
}

void AdaptivePart::leave_whole(const Triangle& triangle) {
    if (triangle.is_settled) now_settled_.push_back(triangle);
    leaves_.push_back(triangle);
}

std::size_t AdaptivePart::longest_edge_of(const Triangle& triangle) const {
    const auto longest = std::max_element(triangle.edges.begin(), triangle.edges.end(),
                                          [&](std::uint32_t a, std::uint32_t b) {
                                              return edges_[a].length_px < edges_[b].length_px;
                                          });
    return static_cast<std::size_t>(longest - triangle.edges.begin());
}

}  // namespace lumi
