#pragma once

#include <cstddef>
#include <vector>

namespace lumi {

/// What something costs and how far it is off; less is better in both.
struct CostAndError {
    double cost = 0.0;
    double error = 0.0;
};

/// The indices of the points that no other point beats in one without being worse in the other, by
/// rising cost. Of equal points the first is kept.
[[nodiscard]] std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points);

}  // namespace lumi
