#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lumi {

/// The value that `share` (0 to 1) of the others are not above; `of_none` where there are none.
[[nodiscard]] inline double quantile_of(std::vector<double> values, double share,
                                        double of_none = 0.0) {
    if (values.empty()) return of_none;
    const auto place = values.begin() +
                       static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// The middle of the values, of an even number the upper one of the two; `of_none` where there are
/// none.
[[nodiscard]] inline double median_of(std::vector<double> values, double of_none = 0.0) {
    if (values.empty()) return of_none;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace lumi
