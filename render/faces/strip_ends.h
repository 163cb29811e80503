#pragma once

#include <vector>

namespace lumi {

/// A picture is divided into strips from the left to the right, as wide as their shares, which sum
/// to 1: where each ends, in columns of a picture of this width.
[[nodiscard]] std::vector<int> strip_ends(const std::vector<double>& shares, int width_px);

}  // namespace lumi
