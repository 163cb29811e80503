#pragma once

#include <cstddef>
#include <vector>

namespace lumi {

/// Some of the things to choose among, in ascending order, and the share in which they are chosen.
struct GradualChoice {
    std::vector<std::size_t> chosen;
    double share = 1.0;
};

/// The `size` things of the least cost, in a way that nothing changes all at once: one that costs
/// no more than a twenty-fifth more than another is chosen instead of it for a share, half of it
/// where both cost the same. Shares sum to 1 and are continuous in the costs, as long as no more
/// than eight things cost nearly the same; at most four choices, in an order that does not depend
/// on the costs. Costs are positive. All things, if there are no more than `size`.
[[nodiscard]] std::vector<GradualChoice> gradual_choices(const std::vector<double>& costs,
                                                         std::size_t size);

}  // namespace lumi
