#include "meshing/cameras/camera_star.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lumi {
namespace {

constexpr double kSameDirection_rad = 1e-6;
/// Distances are compared in steps of this share of the usual one: poses of one place that are
/// turned differently are rounded differently.
constexpr double kDistanceStep = 1e-9;

/// Pairs within kSameDirection_rad, found along an axis that no usual row of cameras is
/// perpendicular to.
std::vector<std::pair<std::size_t, std::size_t>> pairs_in_one_direction(
    const std::vector<Eigen::Vector3d>& directions) {
    const Eigen::Vector3d axis = Eigen::Vector3d(0.6123, 0.5311, 0.5857).normalized();
    std::vector<std::pair<double, std::size_t>> sorted;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        sorted.emplace_back(axis.dot(directions[i]), i);
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        for (std::size_t j = i + 1; j < sorted.size(); ++j) {
            if (sorted[j].first - sorted[i].first > kSameDirection_rad) break;
            const std::size_t a = std::min(sorted[i].second, sorted[j].second);
            const std::size_t b = std::max(sorted[i].second, sorted[j].second);
            if ((directions[a] - directions[b]).norm() <= kSameDirection_rad) {
                pairs.emplace_back(a, b);
            }
        }
    }
    return pairs;
}

}  // namespace

CameraStar camera_star(const std::vector<OpticalAxis>& axes,
                       const Eigen::Vector3d& centre_in_world) {
    CameraStar all;
    all.centre_in_world = centre_in_world;
    all.axes = axes;
    for (const OpticalAxis& axis : axes) {
        const Eigen::Vector3d offset = axis.centre_in_world - centre_in_world;
        const double distance = offset.norm();
        all.distances.push_back(distance);
        all.directions.push_back(distance > 0 ? Eigen::Vector3d(offset / distance)
                                              : Eigen::Vector3d(-axis.direction_in_world));
    }

    const double usual_distance = median_distance(axes, centre_in_world);
    std::vector<char> keep(axes.size(), 1);
    for (const auto& [a, b] : pairs_in_one_direction(all.directions)) {
        keep[stands_for_both(all, a, b, usual_distance) ? b : a] = 0;
    }
    return kept_cameras(all, keep);
}

bool stands_for_both(const CameraStar& star, std::size_t a, std::size_t b, double usual_distance) {
    const auto steps_off = [&](std::size_t camera) {
        return std::round(std::abs(star.distances[camera] / usual_distance - 1) / kDistanceStep);
    };
    const double off_a = steps_off(a);
    const double off_b = steps_off(b);
    return off_a != off_b ? off_a < off_b : a < b;
}

double largest_distance(const CameraStar& star) {
    return *std::max_element(star.distances.begin(), star.distances.end());
}

CameraStar kept_cameras(const CameraStar& star, const std::vector<char>& keep) {
    CameraStar kept;
    kept.centre_in_world = star.centre_in_world;
    kept.hidden_cameras = star.hidden_cameras;
    for (std::size_t i = 0; i < star.axes.size(); ++i) {
        if (!keep[i]) {
            ++kept.hidden_cameras;
            continue;
        }
        kept.axes.push_back(star.axes[i]);
        kept.directions.push_back(star.directions[i]);
        kept.distances.push_back(star.distances[i]);
    }
    return kept;
}

}  // namespace lumi
