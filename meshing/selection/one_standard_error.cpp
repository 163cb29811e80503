#include "meshing/selection/one_standard_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "calib/work/mean.h"

namespace lumi {
Excess excess_over(const std::vector<double>& losses, const std::vector<double>& least) {
    assert(losses.size() == least.size());
    std::vector<double> excesses;
    for (std::size_t i = 0; i < losses.size(); ++i) excesses.push_back(losses[i] - least[i]);
    Excess excess{mean_of(excesses), 0.0};
    double squares = 0;
    for (const double of_place : excesses) squares += std::pow(of_place - excess.mean, 2);
    const auto count = static_cast<double>(excesses.size());
    if (count > 1) excess.standard_error = std::sqrt(squares / (count - 1) / count);
    return excess;
}

double standard_error_over_views(const Excess& excess, std::size_t pairs, std::size_t views) {
    return excess.standard_error *
           std::sqrt((static_cast<double>(pairs) - 1) / static_cast<double>(views));
}

std::size_t simplest_as_good(const std::vector<std::vector<double>>& losses) {
    const auto& least =
        *std::min_element(losses.begin(), losses.end(),
                          [](const auto& a, const auto& b) { return mean_of(a) < mean_of(b); });
    std::size_t simplest = losses.size() - 1;
    for (; simplest > 0; --simplest) {
        const Excess excess = excess_over(losses[simplest], least);
        if (excess.mean <= excess.standard_error) break;
    }
    return simplest;
}

}  // namespace lumi
