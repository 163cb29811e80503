#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lumi {

/// Between which bounds a mean lies.
struct Interval {
    double low = 0.0;
    double high = 0.0;
};

struct BootstrapOptions {
    int resamples = 2000;
    double level = 0.95;
    std::uint64_t seed = 1;
};

/// With fewer values no interval is told. The percentile bootstrap is too short for few: of two
/// values it is their range, which holds the mean of a normal distribution half of the time; an
/// interval of 95 % holds it 84 times in 100 with five values, 86 with six, 90 with ten. Besides,
/// that fewer than six fall on one side of 0 by chance alone is not even below one in twenty.
constexpr std::size_t kFewestForInterval = 6;

/// The percentile bootstrap interval of the mean (Efron and Tibshirani, "An Introduction to the
/// Bootstrap", 1993, section 13.3). The same for the same seed on any machine. Empty for fewer than
/// kFewestForInterval values.
[[nodiscard]] std::optional<Interval> bootstrap_interval(const std::vector<double>& values,
                                                         const BootstrapOptions& options = {});

/// From the least to the greatest of the values; empty when there are none.
[[nodiscard]] std::optional<Interval> range_of(const std::vector<double>& values);

}  // namespace lumi
