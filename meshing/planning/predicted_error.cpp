#include "meshing/planning/predicted_error.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "calib/capture/angle_between.h"
#include "calib/work/median.h"
#include "meshing/cameras/border.h"
#include "meshing/cameras/spherical_triangulation.h"
#include "meshing/warp/parallax.h"

namespace lumi {
namespace {

constexpr double kFarSide_rad = 75.0 * std::numbers::pi / 180.0;
/// A row's widest gap is its outside when it is wider than this.
constexpr double kRowOutside_rad = 2.0 * std::numbers::pi / 3.0;
constexpr double kUsualMatchingError_px = 0.5;

/// The widest distance between two cameras of a track, across the ray to the point.
double baseline_of(const Capture& capture, const ScenePoint& point) {
    double baseline = 0;
    for (const Observation& one : point.track) {
        const Eigen::Vector3d a =
            centre_in_world(capture.views[static_cast<std::size_t>(one.view_index)].cam_from_world);
        const Eigen::Vector3d ray = (point.position_in_world - a).normalized();
        for (const Observation& other : point.track) {
            const Eigen::Vector3d b = centre_in_world(
                capture.views[static_cast<std::size_t>(other.view_index)].cam_from_world);
            baseline = std::max(baseline, ray.cross(b - a).norm());
        }
    }
    return baseline;
}

/// The median distance of a camera to the nearest other one, be it of the same burst: matched with
/// each other, such cameras tell little of depth.
double usual_spacing(const CameraStar& star) {
    std::vector<Eigen::Vector3d> centres;
    for (const auto& axis : star.axes) centres.push_back(axis.centre_in_world);
    return centres.size() < 2 ? 0.0 : quantile_of(nearest_distances(centres), 0.5);
}

Hole hole_at(const CameraStar& star, const Eigen::Vector3d& direction,
             const std::vector<int>& cameras, const DepthUncertainty& uncertainty) {
    Hole hole;
    hole.direction = direction;
    hole.radius_rad = std::numbers::pi;
    for (const int camera : cameras) {
        const auto index = static_cast<std::size_t>(camera);
        hole.distance += star.distances[index] / static_cast<double>(cameras.size());
        hole.radius_rad =
            std::min(hole.radius_rad, angle_between(star.directions[index], direction));
        hole.view_indices.push_back(star.axes[index].view_index);
    }
    const double across =
        2.0 * hole.distance * std::sin(std::min(hole.radius_rad, 0.5 * std::numbers::pi));
    hole.error_px = uncertainty.focal_length_px * uncertainty.inverse_depth * across;
    return hole;
}

/// Where the triangle is widest open: see holes_between.
Eigen::Vector3d middle_of(const std::array<Eigen::Vector3d, 3>& corners) {
    const Eigen::Vector3d circumcentre =
        (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d& from = corners[i];
        const Eigen::Vector3d& to = corners[(i + 1) % 3];
        if (from.cross(to).dot(circumcentre) < 0) return (from + to).normalized();
    }
    return circumcentre;
}

/// Of three directions, or of more on one circle, there is no hull: they are then triangulated as
/// those of cameras that see the scene from one side.
std::vector<std::array<int, 3>> triangles_between(const std::vector<Eigen::Vector3d>& directions) {
    constexpr double kLeastMean = 1e-6;  // Below that no side is opposite to them.
    auto faces = spherical_triangulation(directions);
    if (!faces.empty()) return faces;
    const Eigen::Vector3d sum =
        std::accumulate(directions.begin(), directions.end(), Eigen::Vector3d(0, 0, 0));
    if (sum.norm() < kLeastMean * static_cast<double>(directions.size())) return faces;
    return open_triangulation(directions, -sum.normalized());
}

std::vector<Hole> holes_of_surface(const CameraStar& star, const DepthUncertainty& uncertainty) {
    std::vector<Hole> holes;
    for (const auto& face : triangles_between(star.directions)) {
        std::array<Eigen::Vector3d, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = star.directions[static_cast<std::size_t>(face[i])];
        }
        const Eigen::Vector3d cap = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        if (angle_between(cap, corners[0]) > kFarSide_rad) continue;
        holes.push_back(hole_at(star, middle_of(corners), {face.begin(), face.end()}, uncertainty));
    }
    return holes;
}

std::vector<Hole> holes_of_row(const CameraStar& star, const Eigen::Vector3d& normal,
                               const DepthUncertainty& uncertainty) {
    const Eigen::Vector3d first = normal.unitOrthogonal();
    const Eigen::Vector3d second = normal.cross(first);
    std::vector<double> azimuths;
    for (const Eigen::Vector3d& direction : star.directions) {
        azimuths.push_back(std::atan2(direction.dot(second), direction.dot(first)));
    }
    std::vector<int> order(azimuths.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return azimuths[static_cast<std::size_t>(a)] < azimuths[static_cast<std::size_t>(b)];
    });
    std::vector<Hole> holes;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const int from = order[i];
        const int to = order[(i + 1) % order.size()];
        double gap =
            azimuths[static_cast<std::size_t>(to)] - azimuths[static_cast<std::size_t>(from)];
        if (gap <= 0) gap += 2 * std::numbers::pi;
        if (from == to || gap > kRowOutside_rad) continue;
        const Eigen::Vector3d middle = (star.directions[static_cast<std::size_t>(from)] +
                                        star.directions[static_cast<std::size_t>(to)])
                                           .normalized();
        holes.push_back(hole_at(star, middle, {from, to}, uncertainty));
    }
    return holes;
}

}  // namespace

DepthUncertainty depth_uncertainty(const Capture& capture, const std::vector<int>& view_indices,
                                   const CameraStar& star) {
    std::vector<double> focal_lengths;
    for (const int index : view_indices) {
        const View& view = capture.views[static_cast<std::size_t>(index)];
        focal_lengths.push_back(focal_length_px(camera_of(capture, view)).mean());
    }
    DepthUncertainty uncertainty;
    if (focal_lengths.empty()) return uncertainty;
    uncertainty.focal_length_px = quantile_of(std::move(focal_lengths), 0.5);
    std::vector<double> deviations;
    for (const ScenePoint& point : capture.points) {
        const double baseline = baseline_of(capture, point);
        if (!(baseline > 0)) continue;
        const double error_px = point.error_px > 0 ? point.error_px : kUsualMatchingError_px;
        deviations.push_back(error_px / (uncertainty.focal_length_px * baseline));
    }
    if (!deviations.empty()) {
        uncertainty.inverse_depth = quantile_of(std::move(deviations), 0.5);
    } else if (const double spacing = usual_spacing(star); spacing > 0) {
        uncertainty.inverse_depth =
            kUsualMatchingError_px / (uncertainty.focal_length_px * spacing);
    }
    return uncertainty;
}

std::vector<Hole> holes_between(const CameraStar& star, bool in_a_row,
                                const Eigen::Vector3d& row_normal,
                                const DepthUncertainty& uncertainty) {
    std::vector<Hole> holes = in_a_row ? holes_of_row(star, row_normal, uncertainty)
                                       : holes_of_surface(star, uncertainty);
    std::stable_sort(holes.begin(), holes.end(),
                     [](const Hole& a, const Hole& b) { return a.error_px > b.error_px; });
    return holes;
}

}  // namespace lumi
