#include "meshing/warp/parallax.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "calib/work/median.h"

namespace lumi {

std::vector<std::size_t> with_parallax(const std::vector<double>& parallaxes, std::size_t most) {
    std::vector<std::size_t> places;
    if (parallaxes.empty()) return places;
    const double least =
        kLeastParallaxShare * *std::max_element(parallaxes.begin(), parallaxes.end());
    for (std::size_t i = 0; i < parallaxes.size() && places.size() < most; ++i) {
        if (parallaxes[i] >= least) places.push_back(i);
    }
    return places;
}

std::vector<double> nearest_distances(const std::vector<Eigen::Vector3d>& centres) {
    std::vector<double> nearest(centres.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < centres.size(); ++i) {
        for (std::size_t j = 0; j < centres.size(); ++j) {
            if (i != j) nearest[i] = std::min(nearest[i], (centres[i] - centres[j]).norm());
        }
    }
    return nearest;
}

double nearest_baseline(const Eigen::Vector3d& centre,
                        const std::vector<Eigen::Vector3d>& centres) {
    constexpr std::ptrdiff_t kMostAround = 16;
    constexpr double kSamePlace = 1e-6;  // Of the extent of all.
    std::vector<double> distances;
    double extent = 0.0;
    for (const Eigen::Vector3d& other : centres) {
        distances.push_back((other - centre).norm());
        extent = std::max(extent, distances.back());
    }
    std::erase_if(distances, [&](double distance) { return distance <= kSamePlace * extent; });
    const auto around = std::min(kMostAround, static_cast<std::ptrdiff_t>(distances.size()));
    std::partial_sort(distances.begin(), distances.begin() + around, distances.end());
    distances.resize(static_cast<std::size_t>(around));
    const std::vector<std::size_t> first = with_parallax(distances, 1);
    return first.empty() ? 0.0 : distances[first.front()];
}

double typical_baseline(const std::vector<Eigen::Vector3d>& centres) {
    std::vector<double> baselines;
    for (const Eigen::Vector3d& centre : centres) {
        const double baseline = nearest_baseline(centre, centres);
        if (baseline > 0) baselines.push_back(baseline);
    }
    return quantile_of(std::move(baselines), 0.5);
}

}  // namespace lumi
