#pragma once

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

/// The percentile bootstrap interval of the mean (Efron and Tibshirani, "An Introduction to the
/// Bootstrap", 1993, section 13.3). The same for the same seed on any machine. Empty for fewer than
/// two values: one says nothing about spread.
[[nodiscard]] std::optional<Interval> bootstrap_interval(const std::vector<double>& values,
                                                         const BootstrapOptions& options = {});

}  // namespace lumi
