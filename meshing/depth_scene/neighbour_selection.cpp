#include "meshing/depth_scene/neighbour_selection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lumi {
namespace {

constexpr std::size_t kMinSharedPoints = 12;

double angle_weight(const Eigen::Vector3d& point, const Eigen::Vector3d& centre_a,
                    const Eigen::Vector3d& centre_b) {
    constexpr double kBestDeg = 6.0;
    constexpr double kNarrowDeg = 2.5;
    constexpr double kWideDeg = 12.0;
    const Eigen::Vector3d to_a = centre_a - point;
    const Eigen::Vector3d to_b = centre_b - point;
    const double angle_deg =
        std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b)) * 180.0 / std::numbers::pi;
    const double deviation =
        (angle_deg - kBestDeg) / (angle_deg < kBestDeg ? kNarrowDeg : kWideDeg);
    return std::exp(-0.5 * deviation * deviation);
}

/// Patches of one size are compared: the larger the point is in one view than in the other, the
/// less it tells (after Goesele et al., ICCV 2007).
double size_weight(const Eigen::Vector3d& point, const DepthView& a, const DepthView& b) {
    constexpr double kAlike = 1.2;  // Times as large: one standard deviation.
    const double depth_in_a = (a.cam_from_world * point).z();
    const double depth_in_b = (b.cam_from_world * point).z();
    if (!(depth_in_a > 0 && depth_in_b > 0)) return 0.0;
    const double times_as_large = focal_length_px(a.camera).mean() * depth_in_b /
                                  (focal_length_px(b.camera).mean() * depth_in_a);
    const double deviation = std::log(times_as_large) / std::log(kAlike);
    return std::exp(-0.5 * deviation * deviation);
}

/// Pixels of the view at one inverse depth, as points in the world.
std::vector<Eigen::Vector3d> grid_points(const DepthView& view) {
    constexpr int kSide = 7;
    const double depth = 2.0 / (view.range.far + view.range.near);
    const Rigid3 world_from_cam = inverse(view.cam_from_world);
    std::vector<Eigen::Vector3d> points;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const Eigen::Vector2d pixel((x + 0.5) * view.camera.width_px / kSide,
                                        (y + 0.5) * view.camera.height_px / kSide);
            points.push_back(world_from_cam * (depth * unproject(view.camera, pixel)));
        }
    }
    return points;
}

bool sees(const DepthView& view, const Eigen::Vector3d& point_in_world) {
    const auto pixel = project(view.camera, view.cam_from_world * point_in_world);
    return pixel && is_inside(view.camera, *pixel);
}

/// Scores of all views as neighbours of `index`, by tracks if it has enough of them.
std::vector<double> scores_of(const DepthScene& scene, int index,
                              const std::vector<Eigen::Vector3d>& centres) {
    const auto self = static_cast<std::size_t>(index);
    std::vector<double> scores(scene.views.size(), 0.0);
    const auto worth = [&](const Eigen::Vector3d& point, std::size_t other) {
        return angle_weight(point, centres[self], centres[other]) *
               size_weight(point, scene.views[self], scene.views[other]);
    };
    if (scene.views[self].points.size() >= kMinSharedPoints) {
        for (const ScenePoint& point : scene.points) {
            const bool seen = std::any_of(point.track.begin(), point.track.end(),
                                          [&](const auto& o) { return o.view_index == index; });
            if (!seen) continue;
            for (const Observation& other : point.track) {
                const auto j = static_cast<std::size_t>(other.view_index);
                scores[j] += worth(point.position_in_world, j);
            }
        }
    } else if (scene.views[self].range.near > 0) {
        for (const Eigen::Vector3d& point : grid_points(scene.views[self])) {
            for (std::size_t j = 0; j < scores.size(); ++j) {
                if (!sees(scene.views[j], point)) continue;
                scores[j] += worth(point, j);
            }
        }
    }
    scores[self] = 0.0;
    return scores;
}

std::vector<int> choose_greedily(std::vector<double> scores, const Eigen::Vector3d& centre,
                                 const std::vector<Eigen::Vector3d>& centres, int max_neighbours) {
    std::vector<int> chosen;
    const double worthwhile = 0.01 * *std::max_element(scores.begin(), scores.end());
    while (static_cast<int>(chosen.size()) < max_neighbours) {
        const auto best = std::max_element(scores.begin(), scores.end());
        if (*best <= worthwhile) break;
        const auto index = static_cast<std::size_t>(best - scores.begin());
        chosen.push_back(static_cast<int>(index));
        const Eigen::Vector3d direction = (centres[index] - centre).normalized();
        for (std::size_t j = 0; j < scores.size(); ++j) {
            const double same_side = direction.dot((centres[j] - centre).normalized());
            scores[j] *= 1.0 - 0.5 * std::max(0.0, same_side);
        }
        scores[index] = 0.0;
    }
    return chosen;
}

}  // namespace

std::vector<std::vector<int>> select_neighbours(const DepthScene& scene, int max_neighbours) {
    std::vector<Eigen::Vector3d> centres;
    for (const DepthView& view : scene.views) {
        centres.push_back(centre_in_world(view.cam_from_world));
    }
    std::vector<std::vector<int>> neighbours;
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
        neighbours.push_back(choose_greedily(scores_of(scene, static_cast<int>(i), centres),
                                             centres[i], centres, max_neighbours));
    }
    return neighbours;
}

}  // namespace lumi
