#include "calib/poses/pair_ties.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace lumi {
namespace {

/// The view that stands for all that hang together with it.
int root_of(std::vector<int>& parents, int view) {
    while (parents[static_cast<std::size_t>(view)] != view) {
        int& parent = parents[static_cast<std::size_t>(view)];
        parent = parents[static_cast<std::size_t>(parent)];
        view = parent;
    }
    return view;
}

}  // namespace

PairTies::PairTies(int views, std::vector<PairTie> pairs)
    : branches_(static_cast<std::size_t>(views)) {
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const PairTie& a, const PairTie& b) { return a.matches > b.matches; });
    std::vector<int> parents(static_cast<std::size_t>(views));
    std::iota(parents.begin(), parents.end(), 0);
    for (const PairTie& pair : pairs) {
        const int first = root_of(parents, pair.first);
        const int second = root_of(parents, pair.second);
        if (first == second) continue;
        parents[static_cast<std::size_t>(first)] = second;
        branches_[static_cast<std::size_t>(pair.first)].push_back({pair.second, pair.matches});
        branches_[static_cast<std::size_t>(pair.second)].push_back({pair.first, pair.matches});
    }
}

std::size_t PairTies::between(int first, int second) const {
    struct Step {
        int view;
        int from;
        std::size_t weakest;
    };
    std::vector<Step> open{{first, -1, std::numeric_limits<std::size_t>::max()}};
    while (!open.empty()) {
        const Step step = open.back();
        open.pop_back();
        if (step.view == second) return step.weakest;
        for (const Branch& branch : branches_[static_cast<std::size_t>(step.view)]) {
            if (branch.view == step.from) continue;
            open.push_back({branch.view, step.view, std::min(step.weakest, branch.matches)});
        }
    }
    return 0;
}

}  // namespace lumi
