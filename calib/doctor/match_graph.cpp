#include "calib/doctor/match_graph.h"

#include <algorithm>
#include <numeric>

namespace lumi {
namespace {

/// The groups of the graph without one photograph (-1: with all).
std::vector<std::vector<int>> groups_without(const MatchGraph& graph, int missing) {
    std::vector<int> parent(static_cast<std::size_t>(graph.photographs));
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int index) {
        while (parent[static_cast<std::size_t>(index)] != index) {
            index = parent[static_cast<std::size_t>(index)] =
                parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(index)])];
        }
        return index;
    };
    for (const auto& [first, second] : graph.pairs) {
        if (first == missing || second == missing) continue;
        parent[static_cast<std::size_t>(root(second))] = root(first);
    }
    std::vector<std::vector<int>> of_root(static_cast<std::size_t>(graph.photographs));
    for (int index = 0; index < graph.photographs; ++index) {
        if (index != missing) of_root[static_cast<std::size_t>(root(index))].push_back(index);
    }
    std::erase_if(of_root, [](const std::vector<int>& group) { return group.empty(); });
    std::stable_sort(of_root.begin(), of_root.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return of_root;
}

}  // namespace

std::vector<std::vector<int>> groups_of(const MatchGraph& graph) {
    return groups_without(graph, -1);
}

std::vector<int> bridging_photographs(const MatchGraph& graph) {
    const std::size_t groups = groups_of(graph).size();
    std::vector<char> is_linked(static_cast<std::size_t>(graph.photographs), 0);
    for (const auto& [first, second] : graph.pairs) {
        is_linked[static_cast<std::size_t>(first)] = is_linked[static_cast<std::size_t>(second)] =
            1;
    }
    std::vector<int> bridging;
    for (int index = 0; index < graph.photographs; ++index) {
        if (is_linked[static_cast<std::size_t>(index)] == 0) continue;
        if (groups_without(graph, index).size() > groups) bridging.push_back(index);
    }
    return bridging;
}

}  // namespace lumi
