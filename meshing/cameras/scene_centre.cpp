#include "meshing/cameras/scene_centre.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "calib/work/median.h"

namespace lumi {
namespace {

/// How much the depth that a camera sees weighs against its optical axis: hand-held cameras are
/// pointed less exactly than the depth is measured, but axes from all around decide by themselves.
constexpr double kSeenDepthWeight = 0.1;
/// The same for a depth that is only assumed: just enough to place the centre on parallel axes.
constexpr double kAssumedDepthWeight = 1e-3;

struct WeighedDepth {
    double depth = 0.0;
    double weight = 0.0;
};

/// Depth that is assumed where no camera sees any point: a few times the extent of the cameras.
double assumed_depth(const std::vector<OpticalAxis>& axes) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const OpticalAxis& axis : axes) mean += axis.centre_in_world;
    mean /= static_cast<double>(axes.size());
    const double extent = median_distance(axes, mean);
    return extent > 0 ? 3.0 * extent : 1.0;
}

/// The normal equations of one iteration, relative to `origin` for the sake of precision.
Eigen::Vector3d weighted_centre(const std::vector<OpticalAxis>& axes,
                                const std::vector<WeighedDepth>& depths,
                                const std::vector<double>& weights, const Eigen::Vector3d& origin) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const Eigen::Vector3d& direction = axes[i].direction_in_world;
        const Eigen::Matrix3d along = direction * direction.transpose();
        const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along;
        const Eigen::Vector3d centre = axes[i].centre_in_world - origin;
        const auto& [depth, depth_weight] = depths[i];
        normal += weights[i] * (across + depth_weight * along);
        right +=
            weights[i] * (across * centre + depth_weight * (along * centre + depth * direction));
    }
    return origin + normal.ldlt().solve(right);
}

/// Distance of the point from where camera i would want it, in the metric of `weighted_centre`.
double residual(const OpticalAxis& axis, const WeighedDepth& wanted, const Eigen::Vector3d& point) {
    const Eigen::Vector3d offset = point - axis.centre_in_world;
    const double along = offset.dot(axis.direction_in_world);
    const double across_squared = std::max(0.0, offset.squaredNorm() - along * along);
    return std::sqrt(across_squared + wanted.weight * std::pow(along - wanted.depth, 2));
}

std::vector<char> listed_views(const Capture& capture, const std::vector<int>& view_indices) {
    std::vector<char> listed(capture.views.size(), 0);
    for (const int index : view_indices) listed[static_cast<std::size_t>(index)] = 1;
    return listed;
}

}  // namespace

std::vector<OpticalAxis> optical_axes(const Capture& capture,
                                      const std::vector<int>& view_indices) {
    std::vector<std::vector<double>> depths(capture.views.size());
    for (const ScenePoint& point : capture.points) {
        for (const Observation& seen : point.track) {
            const auto view = static_cast<std::size_t>(seen.view_index);
            const double z = (capture.views[view].cam_from_world * point.position_in_world).z();
            if (z > 0) depths[view].push_back(z);
        }
    }
    std::vector<OpticalAxis> axes;
    for (const int index : view_indices) {
        const auto view = static_cast<std::size_t>(index);
        const Rigid3& cam_from_world = capture.views[view].cam_from_world;
        axes.push_back({index, centre_in_world(cam_from_world),
                        optical_axis_in_world(cam_from_world), median_of(std::move(depths[view]))});
    }
    return axes;
}

std::vector<Eigen::Vector3d> visible_points(const Capture& capture,
                                            const std::vector<int>& view_indices,
                                            std::size_t max_points) {
    const std::vector<char> listed = listed_views(capture, view_indices);
    const bool any_track =
        std::any_of(capture.points.begin(), capture.points.end(),
                    [](const ScenePoint& point) { return !point.track.empty(); });
    std::vector<Eigen::Vector3d> all;
    for (const ScenePoint& point : capture.points) {
        const bool visible =
            !any_track ||
            std::any_of(point.track.begin(), point.track.end(), [&listed](const Observation& seen) {
                return listed[static_cast<std::size_t>(seen.view_index)];
            });
        if (visible) all.push_back(point.position_in_world);
    }
    if (all.size() <= max_points) return all;
    std::vector<Eigen::Vector3d> thinned;
    for (std::size_t i = 0; i < max_points; ++i) {
        thinned.push_back(all[i * all.size() / max_points]);
    }
    return thinned;
}

Eigen::Vector3d estimate_scene_centre(const std::vector<OpticalAxis>& axes) {
    std::vector<double> seen;
    for (const OpticalAxis& axis : axes) {
        if (axis.depth > 0) seen.push_back(axis.depth);
    }
    const double usual_depth = seen.empty() ? assumed_depth(axes) : median_of(std::move(seen));
    std::vector<WeighedDepth> depths;
    for (const OpticalAxis& axis : axes) {
        depths.push_back(axis.depth > 0 ? WeighedDepth{axis.depth, kSeenDepthWeight}
                                        : WeighedDepth{usual_depth, kAssumedDepthWeight});
    }

    std::vector<double> weights(axes.size(), 1.0);
    Eigen::Vector3d centre = axes.front().centre_in_world;
    constexpr int kIterations = 20;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        centre = weighted_centre(axes, depths, weights, axes.front().centre_in_world);
        std::vector<double> residuals;
        for (std::size_t i = 0; i < axes.size(); ++i) {
            residuals.push_back(residual(axes[i], depths[i], centre));
        }
        // Below a thousandth of the depth the axes agree, and weights would only follow rounding.
        const double scale = std::max(2.0 * median_of(residuals), 1e-3 * usual_depth);
        for (std::size_t i = 0; i < axes.size(); ++i) {
            weights[i] = 1.0 / (1.0 + std::pow(residuals[i] / scale, 2));
        }
    }
    return centre;
}

double median_distance(const std::vector<OpticalAxis>& axes,
                       const Eigen::Vector3d& point_in_world) {
    std::vector<double> distances;
    for (const OpticalAxis& axis : axes) {
        distances.push_back((axis.centre_in_world - point_in_world).norm());
    }
    return median_of(std::move(distances));
}

Eigen::Vector3d improve_scene_centre(const Eigen::Vector3d& start, double reach, double least_gain,
                                     int most_evaluations,
                                     const std::function<double(const Eigen::Vector3d&)>& value) {
    Eigen::Vector3d best = start;
    double best_value = value(best);
    int evaluations = 1;
    for (double step = reach / 2; step >= reach / 32; step /= 2) {
        constexpr int kMaxMoves = 4;
        bool moved = true;
        for (int moves = 0; moved && moves < kMaxMoves; ++moves) {
            moved = false;
            for (int direction = 0; direction < 6; ++direction) {
                Eigen::Vector3d candidate = best;
                candidate[direction / 2] += direction % 2 == 0 ? step : -step;
                if ((candidate - start).norm() > reach) continue;
                if (evaluations++ >= most_evaluations) return best;
                const double candidate_value = value(candidate);
                if (!(candidate_value > best_value + least_gain)) continue;
                best = candidate;
                best_value = candidate_value;
                moved = true;
            }
        }
    }
    return best;
}

}  // namespace lumi
