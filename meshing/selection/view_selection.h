#pragma once

#include <functional>
#include <vector>

namespace lumi {

/// What a choice of views costs at each held-out place; the same places in the same order each
/// time.
using HeldOutLosses = std::function<std::vector<double>(const std::vector<int>& views)>;

/// One choice on the way from all views to few.
struct ViewChoice {
    std::vector<int> views;
    std::vector<double> losses;
    double mean_loss = 0.0;
    double mean_excess = 0.0;     ///< Over the choice with the least loss.
    double standard_error = 0.0;  ///< Of that difference, over the held-out places.
};

struct ViewSelection {
    std::vector<ViewChoice> curve;  ///< All views first, then ever fewer.
    std::size_t chosen = 0;
};

/// Numbers of views to try: all, then each time a quarter less, down to `least`.
[[nodiscard]] std::vector<int> selection_sizes(int views, int least);

/// Tries the first views of an order (view_worth.h), ascending, in each of the sizes and chooses
/// the fewest whose loss cannot be told from the least: by the one-standard-error rule (Breiman et
/// al. 1984), on differences at the same held-out places. `sizes` must not be empty.
[[nodiscard]] ViewSelection select_views(const std::vector<int>& by_worth,
                                         const std::vector<int>& sizes,
                                         const HeldOutLosses& losses_of);

}  // namespace lumi
