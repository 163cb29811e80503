#pragma once

#include <cstddef>
#include <vector>

namespace lumi {

/// Two views, by index, and how many of their matches say so.
struct PairTie {
    int first = 0;
    int second = 0;
    std::size_t matches = 0;
};

/// How firmly views hang together by chains of pairs (Hu, The maximum capacity route problem, 1961:
/// the widest chain runs along the maximum spanning tree).
class PairTies {
 public:
    PairTies(int views, std::vector<PairTie> pairs);

    /// Of the chains from one view to another, the one whose weakest pair has the most matches: so
    /// many has that pair. 0 where there is no chain.
    [[nodiscard]] std::size_t between(int first, int second) const;

 private:
    struct Branch {
        int view;
        std::size_t matches;
    };
    std::vector<std::vector<Branch>> branches_;  ///< Of the spanning tree, by view.
};

}  // namespace lumi
