#include "pipeline/evaluate/rank_correlation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace lumi {
namespace {

std::vector<double> ranks_of(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
    std::vector<double> ranks(values.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first;
        while (last + 1 < order.size() && values[order[last + 1]] == values[order[first]]) ++last;
        const double rank = static_cast<double>(first + last) / 2.0;
        for (std::size_t i = first; i <= last; ++i) ranks[order[i]] = rank;
        first = last + 1;
    }
    return ranks;
}

}  // namespace

std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
    assert(a.size() == b.size());
    if (a.size() < 3) return std::nullopt;
    const std::vector<double> ranks_a = ranks_of(a);
    const std::vector<double> ranks_b = ranks_of(b);
    const double middle = static_cast<double>(a.size() - 1) / 2.0;
    double ab = 0.0;
    double aa = 0.0;
    double bb = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (ranks_a[i] - middle) * (ranks_b[i] - middle);
        aa += (ranks_a[i] - middle) * (ranks_a[i] - middle);
        bb += (ranks_b[i] - middle) * (ranks_b[i] - middle);
    }
    if (aa == 0.0 || bb == 0.0) return std::nullopt;
    return ab / std::sqrt(aa * bb);
}

}  // namespace lumi
