#pragma once

#include <optional>
#include <vector>

namespace lumi {

/// Spearman's rank correlation, -1 to 1; equal values share the mean of their ranks. Empty for
/// fewer than three pairs or when one side does not vary. `a` and `b` must have one length.
[[nodiscard]] std::optional<double> rank_correlation(const std::vector<double>& a,
                                                     const std::vector<double>& b);

}  // namespace lumi
