#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lumi {

/// The middle of the values, of an even number the upper one of the two; `of_none` where there are
/// none.
[[nodiscard]] inline double median_of(std::vector<double> values, double of_none = 0.0) {
    if (values.empty()) return of_none;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace lumi
