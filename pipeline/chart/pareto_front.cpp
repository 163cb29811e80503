#include "pipeline/chart/pareto_front.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace lumi {

std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (points[a].cost != points[b].cost) return points[a].cost < points[b].cost;
        return points[a].error < points[b].error;
    });
    std::vector<std::size_t> front;
    double least_error = std::numeric_limits<double>::infinity();
    for (const std::size_t index : order) {
        if (points[index].error >= least_error) continue;
        least_error = points[index].error;
        front.push_back(index);
    }
    return front;
}

}  // namespace lumi
