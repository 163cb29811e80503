#pragma once

#include <cstddef>
#include <vector>

namespace lumi {

/// How much worse a choice is than another one, measured at the same places.
struct Excess {
    double mean = 0.0;
    double standard_error = 0.0;  ///< Of the mean, over the places; 0 for a single place.
};

/// Of `losses` over `least`, place by place. Both must be of one size.
[[nodiscard]] Excess excess_over(const std::vector<double>& losses,
                                 const std::vector<double>& least);

/// Of a mean over pairs of views: a view is part of many pairs, which are not independent. There
/// are as many observations as views.
[[nodiscard]] double standard_error_over_views(const Excess& excess, std::size_t pairs,
                                               std::size_t views);

/// The simplest choice whose loss cannot be told from the least: the one-standard-error rule
/// (Breiman et al., Classification and Regression Trees, 1984, section 3.4.3) on differences at the
/// same places. `losses` are those of each choice, the richest first; there must be one.
[[nodiscard]] std::size_t simplest_as_good(const std::vector<std::vector<double>>& losses);

}  // namespace lumi
