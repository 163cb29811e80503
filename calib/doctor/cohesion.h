#pragma once

#include <vector>

#include "calib/doctor/match_graph.h"

namespace lumi {

/// How photographs hang together.
struct Cohesion {
    std::vector<std::vector<int>> groups;  ///< See groups_of.
    double largest_share = 0.0;            ///< Of all photographs, those in the largest group.

    /// Whether the pose stage may place enough of them.
    [[nodiscard]] bool is_usable() const;
    [[nodiscard]] bool is_whole() const { return largest_share > 0.9; }
};
[[nodiscard]] Cohesion cohesion_of(const MatchGraph& graph);

/// The photographs that are kept (one entry each), counted anew, and the pairs among them.
[[nodiscard]] MatchGraph part_of(const MatchGraph& graph, const std::vector<char>& is_kept);

}  // namespace lumi
