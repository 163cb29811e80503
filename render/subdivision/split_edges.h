#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "render/subdivision/coarse_triangles.h"
#include "render/subdivision/edge_table.h"

namespace lumi {

/// An edge of a subdivision, between two of its vertices.
struct SplitEdge {
    static constexpr std::uint32_t kNone = 0xffffffffU;

    std::uint32_t from;
    std::uint32_t to;
    float length_px;
    float split_below = 0.0F;      ///< It is split where errors are relaxed less.
    std::uint32_t middle = kNone;  ///< A vertex, when it was looked up.
    std::array<std::uint32_t, 2> halves{kNone, kNone};  ///< Edges, when they were asked for.
    bool is_crossing_known = false;
    /// Vertices where it crosses an outline, on the surfaces of either end, if it does.
    std::array<std::uint32_t, 2> crossing{kNone, kNone};
    bool is_border = false;  ///< Of the part, with one triangle: the other may be in another part.
};

/// The edges of a subdivision, each made when it is first asked for. `pixels` are its vertices.
class SplitEdges {
 public:
    [[nodiscard]] SplitEdge& operator[](std::uint32_t number) { return edges_[number]; }
    [[nodiscard]] const SplitEdge& operator[](std::uint32_t number) const { return edges_[number]; }

    /// An edge within a triangle, or within a polygon.
    [[nodiscard]] std::uint32_t within(std::uint32_t a, std::uint32_t b,
                                       const std::vector<Eigen::Vector2d>& pixels) {
        const std::uint32_t number = numbers_.number_of(a, b);
        if (number == inner_edges_.size()) inner_edges_.push_back(add(a, b, pixels));
        return inner_edges_[number];
    }

    /// The half of a split edge that ends at a corner.
    [[nodiscard]] std::uint32_t half_at(std::uint32_t number, std::uint32_t corner,
                                        const std::vector<Eigen::Vector2d>& pixels) {
        const std::size_t side = edges_[number].from == corner ? 0 : 1;
        if (edges_[number].halves[side] == SplitEdge::kNone) {
            const std::uint32_t half = add(corner, edges_[number].middle, pixels);
            edges_[half].is_border = edges_[number].is_border;
            edges_[number].halves[side] = half;
        }
        return edges_[number].halves[side];
    }

    /// Reserves memory for so many edges.
    void reserve(std::size_t edges) { edges_.reserve(edges); }

    /// Forgets all of them, but keeps the memory.
    void clear() {
        numbers_.clear();
        inner_edges_.clear();
        edges_.clear();
    }

 private:
    /// Stores the edge from left to right, so that all that is computed of it is the same whichever
    /// triangle asked for it.
    std::uint32_t add(std::uint32_t a, std::uint32_t b,
                      const std::vector<Eigen::Vector2d>& pixels) {
        const auto place = [&](std::uint32_t v) { return std::pair(pixels[v].x(), pixels[v].y()); };
        if (place(b) < place(a)) std::swap(a, b);
        edges_.push_back({a, b, edge_length_px(pixels[a], pixels[b])});
        return static_cast<std::uint32_t>(edges_.size() - 1);
    }

    EdgeTable numbers_;  ///< Of the edges within triangles.
    std::vector<std::uint32_t> inner_edges_;
    std::vector<SplitEdge> edges_;
};

}  // namespace lumi
