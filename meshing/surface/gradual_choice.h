#pragma once

#include <cstddef>
#include <vector>

namespace lumi {

/// Some of several candidates, in ascending order, and the share in which they are chosen.
struct GradualChoice {
    std::vector<std::size_t> chosen;
    double share = 1.0;
};

/// The three candidates of the least cost, or `size` no larger than that, in a way that nothing
/// changes all at once: one that costs no more than a twenty-fifth more than another is chosen
/// instead of it for a share, half of it where both cost the same. Shares sum to 1, and are
/// continuous in the costs wherever the ninth least is more than a twenty-fifth above the third.
/// The order of choices does not depend on the costs, which are positive. All candidates, if there
/// are no more than `size`.
[[nodiscard]] std::vector<GradualChoice> gradual_choices(const std::vector<double>& costs,
                                                         std::size_t size);

}  // namespace lumi
