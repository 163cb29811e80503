#include "meshing/selection/view_selection.h"

#include <algorithm>
#include <string>

#include "calib/work/error.h"
#include "meshing/selection/one_standard_error.h"

namespace lumi {
namespace {

void require_views(int size, std::size_t views) {
    if (size >= 1 && static_cast<std::size_t>(size) <= views) return;
    throw Error(ErrorKind::kUsage, "E-SELECT-SIZE",
                "a choice of " + std::to_string(size) + " out of " + std::to_string(views) +
                    " views was asked for",
                "ask for at least 1 and at most all of them");
}

}  // namespace

std::vector<int> selection_sizes(int views, int least) {
    std::vector<int> sizes;
    for (int size = views; size >= std::min(views, least);
         size = std::min(size - 1, size * 3 / 4)) {
        sizes.push_back(size);
        if (size <= 1) break;
    }
    return sizes;
}

ViewSelection select_views(const std::vector<int>& by_worth, const std::vector<int>& sizes,
                           const HeldOutLosses& losses_of) {
    ViewSelection selection;
    std::vector<std::vector<double>> losses;
    for (const int size : sizes) {
        require_views(size, by_worth.size());
        ViewChoice choice;
        choice.views.assign(by_worth.begin(), by_worth.begin() + size);
        std::sort(choice.views.begin(), choice.views.end());
        choice.losses = losses_of(choice.views);
        losses.push_back(choice.losses);
        selection.curve.push_back(std::move(choice));
    }
    selection.chosen = simplest_as_good(losses);
    return selection;
}

}  // namespace lumi
