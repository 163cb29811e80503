#include "render/rivals/cone_of_cameras.h"

#include <algorithm>
#include <limits>

namespace lumi {

double cone_weight(const PassedCamera& camera, double radius) {
    if (!(camera.from_ray > 0)) return camera.share;
    return camera.share * std::max(0.0, 1 - camera.from_ray / radius);
}

double least_cone_radius(const std::vector<PassedCamera>& by_distance) {
    // Between the distances of a camera and the next the sum of weights is linear in 1 / radius:
    // the shares within, less what they sum to times their distances over the radius.
    double shares = 0;
    double shares_by_distance = 0;
    for (std::size_t i = 0; i < by_distance.size(); ++i) {
        shares += by_distance[i].share;
        shares_by_distance += by_distance[i].share * by_distance[i].from_ray;
        if (!(shares > 1)) continue;
        const double radius = shares_by_distance / (shares - 1);
        if (i + 1 == by_distance.size() || radius <= by_distance[i + 1].from_ray) return radius;
    }
    return std::numeric_limits<double>::infinity();
}

}  // namespace lumi
