#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace lumi {

/// The value that stands in place `rank`, from 0 on, when they are in order. There must be one.
template <class Value>
[[nodiscard]] Value value_of_rank(std::vector<Value> values, std::size_t rank) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// The value that `share` (0 to 1) of the others are not above, of two between which it falls the
/// lower one; `of_none` where there are none.
template <class Value = double>
[[nodiscard]] Value quantile_of(std::vector<Value> values, double share,
                                std::type_identity_t<Value> of_none = {}) {
    if (values.empty()) return of_none;
    const auto rank = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
    return value_of_rank(std::move(values), rank);
}

/// The middle of the values, of an even number the upper one of the two, where quantile_of at a
/// half is the lower one; `of_none` where there are none.
template <class Value = double>
[[nodiscard]] Value median_of(std::vector<Value> values, std::type_identity_t<Value> of_none = {}) {
    if (values.empty()) return of_none;
    const std::size_t rank = values.size() / 2;
    return value_of_rank(std::move(values), rank);
}

/// The standard deviation of a normal distribution for each unit of the median of what its values
/// are off by, either way.
inline constexpr double kSigmaPerMedianOff = 1.4826;

}  // namespace lumi
