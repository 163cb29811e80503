#include "meshing/selection/view_selection.h"

#include <algorithm>

#include "meshing/selection/one_standard_error.h"

namespace lumi {

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
        ViewChoice choice;
        choice.views.assign(by_worth.begin(),
                            by_worth.begin() + std::min(size, static_cast<int>(by_worth.size())));
        std::sort(choice.views.begin(), choice.views.end());
        choice.losses = losses_of(choice.views);
        losses.push_back(choice.losses);
        selection.curve.push_back(std::move(choice));
    }
    selection.chosen = simplest_as_good(losses);
    return selection;
}

}  // namespace lumi
