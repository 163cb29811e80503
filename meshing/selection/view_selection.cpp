#include "meshing/selection/view_selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lumi {
namespace {

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) /
           std::max(1.0, static_cast<double>(values.size()));
}

/// How a choice's losses differ from the best one's, place by place.
void compare(ViewChoice& choice, const ViewChoice& best) {
    std::vector<double> excesses;
    for (std::size_t i = 0; i < choice.losses.size(); ++i) {
        excesses.push_back(choice.losses[i] - best.losses[i]);
    }
    choice.mean_excess = mean_of(excesses);
    double squares = 0;
    for (const double excess : excesses) squares += std::pow(excess - choice.mean_excess, 2);
    const auto count = static_cast<double>(excesses.size());
    choice.standard_error = count > 1 ? std::sqrt(squares / (count - 1) / count) : 0.0;
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
    std::size_t best = 0;
    for (const int size : sizes) {
        ViewChoice choice;
        choice.views.assign(by_worth.begin(),
                            by_worth.begin() + std::min(size, static_cast<int>(by_worth.size())));
        std::sort(choice.views.begin(), choice.views.end());
        choice.losses = losses_of(choice.views);
        choice.mean_loss = mean_of(choice.losses);
        selection.curve.push_back(std::move(choice));
        if (selection.curve.back().mean_loss < selection.curve[best].mean_loss) {
            best = selection.curve.size() - 1;
        }
    }
    for (std::size_t i = 0; i < selection.curve.size(); ++i) {
        ViewChoice& choice = selection.curve[i];
        compare(choice, selection.curve[best]);
        const bool is_as_good = choice.mean_excess <= choice.standard_error;
        const bool is_fewer = choice.views.size() <= selection.curve[selection.chosen].views.size();
        if (i == 0 || (is_as_good && is_fewer)) selection.chosen = i;
    }
    return selection;
}

}  // namespace lumi
