#include <algorithm>

#include "render/subdivision/adaptive_part.h"
#include "render/subdivision/hidden_photographs.h"
#include "render/subdivision/outline_crossing.h"

namespace lumi {

/// What is split no more, cut where its edges cross outlines: each piece lies on one surface. Both
/// sides of an edge are cut at the same pixel.
void AdaptivePart::cut_at_outlines(const Triangle& leaf) {
    std::array<bool, 3> crosses{};
    for (std::size_t i = 0; i < 3; ++i) crosses[i] = crosses_outline(leaf.edges[i]);
    switch (std::count(crosses.begin(), crosses.end(), true)) {
        case 0:
            return pieces_.push_back(leaf.corners);
        case 1:
            return cut_in_two(turned_to(true, crosses, leaf));
        case 2:
            return cut_off_last_corner(turned_to(false, crosses, leaf));
        default:
            cut_off_all_corners(leaf);
    }
}

bool AdaptivePart::crosses_outline(std::uint32_t number) {
    SplitEdge& edge = edges_[number];
    if (!edge.is_crossing_known) {
        edge.is_crossing_known = true;
        const std::uint32_t polygon = polygon_of_[edge.from];
        if (const auto crossing =
                outline_crossing((*samplers_)[polygon], vertices_[edge.from], vertices_[edge.to]))
            edge.crossing = {add_looked_up(crossing->at_from, polygon),
                             add_looked_up(crossing->at_to, polygon)};
    }
    return edge.crossing[0] != SplitEdge::kNone;
}

std::uint32_t AdaptivePart::add_looked_up(const BlendVertex& vertex, std::uint32_t polygon) {
    add_vertex(vector_of(vertex.pixel), polygon);
    vertices_.push_back(vertex);
    return static_cast<std::uint32_t>(vertices_.size() - 1);
}

/// Where an edge crosses an outline, on the surface of this corner.
std::uint32_t AdaptivePart::crossing_at(std::uint32_t number, std::uint32_t corner) const {
    const SplitEdge& edge = edges_[number];
    return edge.crossing[edge.from == corner ? 0 : 1];
}

/// The outline ends within the triangle; it crosses the first edge.
void AdaptivePart::cut_in_two(const Triangle& triangle) {
    const auto [a, b, c] = triangle.corners;
    pieces_.push_back({a, crossing_at(triangle.edges[0], a), c});
    pieces_.push_back({crossing_at(triangle.edges[0], b), b, c});
}

/// The first edge is the one that does not cross the outline.
void AdaptivePart::cut_off_last_corner(const Triangle& triangle) {
    const auto [a, b, c] = triangle.corners;
    const auto [edge_ab, edge_bc, edge_ca] = triangle.edges;
    pieces_.push_back({crossing_at(edge_ca, c), crossing_at(edge_bc, c), c});
    const std::uint32_t near_a = crossing_at(edge_ca, a);
    const std::uint32_t near_b = crossing_at(edge_bc, b);
    if ((pixels_[a] - pixels_[near_b]).squaredNorm() <
        (pixels_[b] - pixels_[near_a]).squaredNorm()) {
        pieces_.push_back({a, b, near_b});
        pieces_.push_back({a, near_b, near_a});
    } else {
        pieces_.push_back({a, b, near_a});
        pieces_.push_back({b, near_b, near_a});
    }
}

/// Three surfaces: what is left between them is drawn on the farthest.
void AdaptivePart::cut_off_all_corners(const Triangle& triangle) {
    std::array<std::uint32_t, 3> between{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t corner = triangle.corners[i];
        const std::uint32_t next = crossing_at(triangle.edges[i], corner);
        const std::uint32_t beyond = crossing_at(triangle.edges[i], triangle.corners[(i + 1) % 3]);
        pieces_.push_back({corner, next, crossing_at(triangle.edges[(i + 2) % 3], corner)});
        between[i] =
            vertices_[next].inverse_depth < vertices_[beyond].inverse_depth ? next : beyond;
    }
    pieces_.push_back(between);
}

void AdaptivePart::leave_out_hidden() {
    for (Corners& corners : whole_) {
        const std::uint32_t polygon = polygon_of_[corners[0]];
        const std::array<bool, 3> hidden = hidden_photographs(
            (*samplers_)[polygon],
            {&vertices_[corners[0]], &vertices_[corners[1]], &vertices_[corners[2]]});
        if (hidden == std::array<bool, 3>{}) continue;
        for (std::uint32_t& corner : corners)
            corner = add_looked_up(without(hidden, vertices_[corner]), polygon);
    }
}

}  // namespace lumi
