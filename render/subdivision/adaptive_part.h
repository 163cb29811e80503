#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/subdivision/adaptive_subdivision.h"
#include "render/subdivision/coarse_triangles.h"
#include "render/subdivision/split_edges.h"

namespace lumi {

/// A part of an adaptive subdivision: some coarse triangles, and what they are split into. Parts
/// know nothing of each other. Edges that two of them share are looked up in both, which come to
/// the same: all that is decided of an edge depends on what is seen along it, and on outlines known
/// beside it.
///
/// Level by level, all triangles are split, or not, before any of the next.
class AdaptivePart {
 public:
    /// An empty part, with memory reserved for what one mostly holds.
    AdaptivePart();

    /// Starts anew with the coarse triangles from `first` up to `end`. Keeps references to the
    /// samplers, one a polygon, and to the outlines, for as long as it subdivides; of what was
    /// there before nothing but memory is kept.
    void begin(const CoarseTriangles& coarse, std::size_t first, std::size_t end,
               const std::vector<PatchSampler>& samplers, const OutlineCells& outlines,
               const AdaptiveSubdivisionOptions& options);

    /// Splits triangles with errors relaxed so much, and cuts them at outlines. Adds those that it
    /// finds to `count`, as it finds them, and gives up once there are more than `most`. To be
    /// called for lesser and lesser relaxations once its triangles were kept.
    void subdivide(float relaxation, std::size_t most, std::atomic<std::size_t>& count);

    /// Keeps the triangles that were found last as those that are drawn.
    void keep();

    /// Gives triangles corners of their own where photographs are not to be blended on them
    /// (hidden_photographs.h). To be called once, when the triangles that are drawn were kept.
    void leave_out_hidden();

    /// How many triangles were kept.
    [[nodiscard]] std::size_t count() const { return whole_.size(); }
    /// These triangles, and the vertices that they name.
    void append_to(BlendTriangles& drawn) const;

 private:
    using Corners = std::array<std::uint32_t, 3>;
    /// Corners, and the edges that start from them.
    struct Triangle {
        Corners corners{};
        std::array<std::uint32_t, 3> edges{};
        /// All that it lies in are split in four, and so they are for lesser relaxations.
        bool is_settled = false;
    };

    void add_vertex(const Eigen::Vector2d& pixel, std::uint32_t polygon);
    [[nodiscard]] std::uint32_t inner_edge(std::uint32_t a, std::uint32_t b);
    [[nodiscard]] std::uint32_t half_at(std::uint32_t edge, std::uint32_t corner);
    [[nodiscard]] Triangle triangle_of(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                       bool is_settled);
    // What is decided of triangles and edges: adaptive_part.cpp.
    void split_or_wait(const Triangle& triangle, float relaxation);
    [[nodiscard]] bool knows_enough_of(std::uint32_t number);
    void look_up_new();
    void judge(SplitEdge& edge) const;
    [[nodiscard]] double error_px_of(const SplitEdge& edge) const;
    [[nodiscard]] bool is_split(std::uint32_t number, float relaxation) const;
    [[nodiscard]] bool is_left_whole(const Triangle& triangle) const;
    [[nodiscard]] std::size_t longest_edge_of(const Triangle& triangle) const;
    void look_up_borders_of_thin(float relaxation);
    void leave_whole(const Triangle& triangle);
    // How triangles are split: adaptive_part_splits.cpp.
    /// The triangle rotated so that its first edge is the first whose mark equals `is_marked`.
    [[nodiscard]] static Triangle turned_to(bool is_marked, const std::array<bool, 3>& marks,
                                            const Triangle& triangle);
    [[nodiscard]] std::array<bool, 3> splits_of(const Triangle& triangle, float relaxation) const;
    void split(const Triangle& triangle, float relaxation);
    void split_in_four(const Triangle& triangle);
    void split_in_two(const Triangle& triangle);
    void split_in_three(const Triangle& triangle);
    void split_where_neighbours_did(const Triangle& triangle, const std::array<bool, 3>& is_shared,
                                    float relaxation);
    // What of them is drawn: adaptive_part_cuts.cpp.
    void cut_at_outlines(const Triangle& leaf);
    [[nodiscard]] bool crosses_outline(std::uint32_t number);
    [[nodiscard]] std::uint32_t add_looked_up(const BlendVertex& vertex, std::uint32_t polygon);
    [[nodiscard]] std::uint32_t crossing_at(std::uint32_t number, std::uint32_t corner) const;
    void cut_in_two(const Triangle& triangle);
    void cut_off_last_corner(const Triangle& triangle);
    void cut_off_all_corners(const Triangle& triangle);

    AdaptiveSubdivisionOptions options_;
    const std::vector<PatchSampler>* samplers_ = nullptr;
    const OutlineCells* outlines_ = nullptr;
    float least_edge_px_ = 0.0F;             ///< Shorter ones are not split.
    float max_edge_px_ = 0.0F;               ///< Longer ones are, in any case.
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
    std::vector<Triangle> thin_;   ///< To be split as their neighbours are, at the end.
    std::vector<Corners> pieces_;  ///< Of leaves, cut at outlines.
    std::vector<Corners> whole_;   ///< Pieces that were kept.
};

}  // namespace lumi
