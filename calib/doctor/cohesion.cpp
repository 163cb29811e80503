#include "calib/doctor/cohesion.h"

namespace lumi {

bool Cohesion::is_usable() const {
    constexpr double kUsableShare = 0.4;  // With fewer in one group the pose stage refuses.
    return largest_share >= kUsableShare && groups.front().size() >= 3;
}

Cohesion cohesion_of(const MatchGraph& graph) {
    Cohesion cohesion{groups_of(graph), 0.0};
    if (graph.photographs > 0) {
        cohesion.largest_share =
            static_cast<double>(cohesion.groups.front().size()) / graph.photographs;
    }
    return cohesion;
}

MatchGraph part_of(const MatchGraph& graph, const std::vector<char>& is_kept) {
    MatchGraph part;
    std::vector<int> place;
    for (const char is_in : is_kept) place.push_back(is_in != 0 ? part.photographs++ : -1);
    for (const auto& [first, second] : graph.pairs) {
        const int a = place[static_cast<std::size_t>(first)];
        const int b = place[static_cast<std::size_t>(second)];
        if (a >= 0 && b >= 0) part.pairs.emplace_back(a, b);
    }
    return part;
}

}  // namespace lumi
