#include <algorithm>

#include "render/subdivision/adaptive_part.h"

namespace lumi {

AdaptivePart::Triangle AdaptivePart::turned_to(bool is_marked, const std::array<bool, 3>& marks,
                                               const Triangle& triangle) {
    Triangle turned = triangle;
    const auto first = std::find(marks.begin(), marks.end(), is_marked) - marks.begin();
    std::rotate(turned.corners.begin(), turned.corners.begin() + first, turned.corners.end());
    std::rotate(turned.edges.begin(), turned.edges.begin() + first, turned.edges.end());
    return turned;
}

/// Which edges are split. Of a flat triangle that would be split in four the longest alone is, as
/// all four would be flat.
std::array<bool, 3> AdaptivePart::splits_of(const Triangle& triangle, float relaxation) const {
    std::array<bool, 3> splits{};
    for (std::size_t i = 0; i < 3; ++i) splits[i] = is_split(triangle.edges[i], relaxation);
    if (std::count(splits.begin(), splits.end(), true) < 3) return splits;
    const auto [a, b, c] = triangle.corners;
    const std::size_t longest = longest_edge_of(triangle);
    if (is_flat(pixels_[b] - pixels_[a], pixels_[c] - pixels_[a],
                edges_[triangle.edges[longest]].length_px)) {
        splits = {};
        splits[longest] = true;
    }
    return splits;
}

void AdaptivePart::split(const Triangle& triangle, float relaxation) {
    const std::array<bool, 3> splits = splits_of(triangle, relaxation);
    const auto count = std::count(splits.begin(), splits.end(), true);
    if (count == 0) return leave_whole(triangle);
    if (count == 3) return split_in_four(triangle);
    if (triangle.is_settled) now_settled_.push_back(triangle);
    if (count == 1) return split_in_two(turned_to(true, splits, triangle));
    split_in_three(turned_to(false, splits, triangle));
}

void AdaptivePart::split_in_four(const Triangle& triangle) {
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
void AdaptivePart::split_in_two(const Triangle& triangle) {
    const auto [a, b, c] = triangle.corners;
    const auto [edge_ab, edge_bc, edge_ca] = triangle.edges;
    const std::uint32_t ab = edges_[edge_ab].middle;
    const std::uint32_t across = inner_edge(ab, c);
    next_level_.push_back({{a, ab, c}, {half_at(edge_ab, a), across, edge_ca}});
    next_level_.push_back({{ab, b, c}, {half_at(edge_ab, b), edge_bc, across}});
}

/// The first edge is kept. The quadrilateral that is left is cut along its shorter diagonal.
void AdaptivePart::split_in_three(const Triangle& triangle) {
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

/// A thin triangle, cut from the vertices on its edges to the corners opposite: a vertex beside an
/// edge without one would let a pixel through, as the driver rounds both.
void AdaptivePart::split_where_neighbours_did(const Triangle& triangle,
                                              const std::array<bool, 3>& is_shared,
                                              float relaxation) {
    std::array<bool, 3> splits{};
    for (std::size_t i = 0; i < 3; ++i)
        splits[i] = is_shared[i] && edges_[triangle.edges[i]].middle != SplitEdge::kNone &&
                    is_split(triangle.edges[i], relaxation);
    const auto first = std::find(splits.begin(), splits.end(), true) - splits.begin();
    if (first == 3) return leaves_.push_back(triangle);
    const auto [a, b, c] = turned_to(true, splits, triangle).corners;
    const auto [edge_ab, edge_bc, edge_ca] = turned_to(true, splits, triangle).edges;
    const bool is_bc_shared = is_shared[static_cast<std::size_t>(first + 1) % 3];
    const bool is_ca_shared = is_shared[static_cast<std::size_t>(first + 2) % 3];
    const std::uint32_t ab = edges_[edge_ab].middle;
    const std::uint32_t across = inner_edge(ab, c);
    split_where_neighbours_did({{a, ab, c}, {half_at(edge_ab, a), across, edge_ca}},
                               {true, false, is_ca_shared}, relaxation);
    split_where_neighbours_did({{ab, b, c}, {half_at(edge_ab, b), edge_bc, across}},
                               {true, is_bc_shared, false}, relaxation);
}

}  // namespace lumi
