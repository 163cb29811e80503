#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/depth_search/searched_views.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Where in the eye's picture views know of outlines (view_outlines.h), in cells of a few pixels.
///
/// A subdivision that looks at the corners and the middles of edges alone misses what is smaller
/// than its triangles, and that comes and goes as the eye moves. Views know where something ends
/// before one looks. What one of them knows counts in the whole picture, wherever it is blended, so
/// that both sides of an edge come to the same.
class OutlineCells {
 public:
    /// No outlines.
    OutlineCells() = default;
    /// The outlines that these views know. Those that show next to no parallax against what is
    /// behind them, from the view to the eye, do not count.
    OutlineCells(const Lumigraph& lumigraph, const SearchedViews& views,
                 const std::vector<int>& view_indices, const Eye& eye);

    /// Whether there are outlines in the box around an edge, in whole cells: the boxes around the
    /// three edges of a triangle cover it. The same whichever end is the first.
    [[nodiscard]] bool has_beside(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

 private:
    [[nodiscard]] std::size_t place(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1) +
               static_cast<std::size_t>(column);
    }
    void mark(const Eigen::Vector2d& pixel);
    void sum_up();

    int columns_ = 0;
    int rows_ = 0;
    /// How many cells above and to the left of a cell's corner have an outline (a summed area
    /// table, Crow 1984).
    std::vector<std::uint32_t> counts_;
};

}  // namespace lumi
