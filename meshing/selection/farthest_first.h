#pragma once

#include <functional>
#include <vector>

namespace lumi {

/// `count` of the items 0 to `items` - 1, or all where there are no more: `first`, and then always
/// the one farthest from those before it (Gonzalez 1985), of equals the lowest. `distance` is asked
/// about two different items.
[[nodiscard]] std::vector<int> farthest_first(int items, int first, int count,
                                              const std::function<double(int, int)>& distance);

}  // namespace lumi
