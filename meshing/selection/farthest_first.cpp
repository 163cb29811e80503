#include "meshing/selection/farthest_first.h"

#include <algorithm>
#include <limits>

namespace lumi {

std::vector<int> farthest_first(int items, int first, int count,
                                const std::function<double(int, int)>& distance) {
    constexpr double kChosen = -1.0;
    std::vector<double> to_nearest(static_cast<std::size_t>(items),
                                   std::numeric_limits<double>::infinity());
    std::vector<int> order;
    for (int next = first; static_cast<int>(order.size()) < std::min(items, count);) {
        order.push_back(next);
        to_nearest[static_cast<std::size_t>(next)] = kChosen;
        for (int i = 0; i < items; ++i) {
            double& nearest = to_nearest[static_cast<std::size_t>(i)];
            if (nearest >= 0) nearest = std::min(nearest, distance(i, order.back()));
        }
        next = static_cast<int>(std::max_element(to_nearest.begin(), to_nearest.end()) -
                                to_nearest.begin());
    }
    return order;
}

}  // namespace lumi
