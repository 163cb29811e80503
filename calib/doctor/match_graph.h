#pragma once

#include <utility>
#include <vector>

namespace lumi {

/// Photographs and the pairs of them that show the same things.
struct MatchGraph {
    int photographs = 0;
    std::vector<std::pair<int, int>> pairs;  ///< first < second.
};

/// Photographs that hang together, the largest group first; each ascending. A photograph without a
/// pair is a group of its own.
[[nodiscard]] std::vector<std::vector<int>> groups_of(const MatchGraph& graph);

/// Photographs whose loss would part a group in two (articulation points; Hopcroft and Tarjan,
/// CACM 1973). Ascending.
[[nodiscard]] std::vector<int> bridging_photographs(const MatchGraph& graph);

}  // namespace lumi
