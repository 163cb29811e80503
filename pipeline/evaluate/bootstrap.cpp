#include "pipeline/evaluate/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace lumi {
namespace {

/// The value below which lies `share` of the sorted values, interpolated.
double quantile(const std::vector<double>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double fraction = place - static_cast<double>(below);
    return sorted[below] + fraction * (sorted[above] - sorted[below]);
}

}  // namespace

std::optional<Interval> bootstrap_interval(const std::vector<double>& values,
                                           const BootstrapOptions& options) {
    if (values.size() < kFewestForInterval) return std::nullopt;
    // Distributions of the standard library differ between libraries, its generators do not.
    std::mt19937_64 random(options.seed);
    std::vector<double> means;
    for (int i = 0; i < options.resamples; ++i) {
        double sum = 0.0;
        for (std::size_t k = 0; k < values.size(); ++k) sum += values[random() % values.size()];
        means.push_back(sum / static_cast<double>(values.size()));
    }
    std::sort(means.begin(), means.end());
    const double tail = (1.0 - options.level) / 2.0;
    return Interval{quantile(means, tail), quantile(means, 1.0 - tail)};
}

std::optional<Interval> range_of(const std::vector<double>& values) {
    if (values.empty()) return std::nullopt;
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    return Interval{*least, *greatest};
}

}  // namespace lumi
