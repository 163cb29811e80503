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
};

struct ViewSelection {
    std::vector<ViewChoice> curve;  ///< All views first, then ever fewer.
    std::size_t chosen = 0;
};

/// Numbers of views to try: all, then each time a quarter less, down to `least`.
[[nodiscard]] std::vector<int> selection_sizes(int views, int least);

/// Tries the first views of an order (view_worth.h), ascending, in each of the sizes, which fall,
/// and chooses the fewest whose loss cannot be told from the least (one_standard_error.h). `sizes`
/// must not be empty. Throws Error (E-SELECT-SIZE) where one is less than 1 or more than there are.
[[nodiscard]] ViewSelection select_views(const std::vector<int>& by_worth,
                                         const std::vector<int>& sizes,
                                         const HeldOutLosses& losses_of);

}  // namespace lumi
