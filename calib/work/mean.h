#pragma once

#include <numeric>
#include <vector>

namespace lumi {

/// The mean of the values; `of_none` where there are none.
[[nodiscard]] inline double mean_of(const std::vector<double>& values, double of_none = 0.0) {
    if (values.empty()) return of_none;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace lumi
