#pragma once

#include <utility>

namespace lumi {

struct JumpSearch {
    int halvings = 40;
    double negligible = 0.0;  ///< A stretch that changes by no more is not halved.
};

/// The change of `at` between `low` and `high` at the one place where it changes most abruptly: the
/// half that changes more is halved again.
template <class At, class Difference>
[[nodiscard]] double largest_jump_between(const At& at, const Difference& difference, double low,
                                          double high, const JumpSearch& search) {
    auto at_low = at(low);
    auto at_high = at(high);
    for (int i = 0; i < search.halvings && difference(at_low, at_high) > search.negligible; ++i) {
        const double middle = 0.5 * (low + high);
        auto at_middle = at(middle);
        if (difference(at_low, at_middle) >= difference(at_middle, at_high)) {
            high = middle;
            at_high = std::move(at_middle);
        } else {
            low = middle;
            at_low = std::move(at_middle);
        }
    }
    return difference(at_low, at_high);
}

}  // namespace lumi
