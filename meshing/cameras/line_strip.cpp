#include "meshing/cameras/line_strip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "calib/capture/degrees.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr double kSameAzimuth_rad = 1e-6;
constexpr double kFullTurn = 2 * std::numbers::pi;

/// The star's cameras in the order of their azimuth about the normal.
struct Chain {
    std::vector<std::size_t> cameras;
    std::vector<double> azimuths_rad;  ///< Ascending within a turn, starting behind the widest gap.
    double widest_gap_rad = kFullTurn;
    double usual_gap_rad = 0.0;
};

/// Rotates an ascending chain so that it begins behind its widest gap.
void begin_behind_widest_gap(Chain& chain) {
    const std::size_t count = chain.cameras.size();
    std::vector<double> gaps(count);  // gaps[i] is the one before camera i
    for (std::size_t i = 0; i < count; ++i) {
        gaps[i] = i == 0 ? chain.azimuths_rad.front() + kFullTurn - chain.azimuths_rad.back()
                         : chain.azimuths_rad[i] - chain.azimuths_rad[i - 1];
    }
    const auto widest = std::max_element(gaps.begin(), gaps.end()) - gaps.begin();
    for (std::ptrdiff_t i = 0; i < widest; ++i) {
        chain.azimuths_rad[static_cast<std::size_t>(i)] += kFullTurn;
    }
    chain.widest_gap_rad = gaps[static_cast<std::size_t>(widest)];
    std::rotate(chain.cameras.begin(), chain.cameras.begin() + widest, chain.cameras.end());
    std::rotate(chain.azimuths_rad.begin(), chain.azimuths_rad.begin() + widest,
                chain.azimuths_rad.end());
    chain.usual_gap_rad = median_of(std::move(gaps));
}

Chain chain_by_azimuth(const CameraStar& star, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d first = normal.unitOrthogonal();
    const Eigen::Vector3d second = normal.cross(first);
    std::vector<double> azimuths_rad;
    for (const Eigen::Vector3d& direction : star.directions) {
        azimuths_rad.push_back(std::atan2(direction.dot(second), direction.dot(first)));
    }
    std::vector<std::size_t> order(azimuths_rad.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return azimuths_rad[a] < azimuths_rad[b];
    });

    const double usual_distance = median_distance(star.axes, star.centre_in_world);
    Chain chain;
    for (const std::size_t camera : order) {
        const bool hidden = !chain.cameras.empty() &&
                            azimuths_rad[camera] - chain.azimuths_rad.back() <= kSameAzimuth_rad;
        if (!hidden) {
            chain.cameras.push_back(camera);
            chain.azimuths_rad.push_back(azimuths_rad[camera]);
        } else if (stands_for_both(star, camera, chain.cameras.back(), usual_distance)) {
            chain.cameras.back() = camera;
        }
    }
    // The last may stand where the first does, a whole turn further.
    const double over_the_end_rad =
        chain.azimuths_rad.front() + kFullTurn - chain.azimuths_rad.back();
    if (over_the_end_rad <= kSameAzimuth_rad) {
        if (stands_for_both(star, chain.cameras.back(), chain.cameras.front(), usual_distance)) {
            chain.cameras.front() = chain.cameras.back();
        }
        chain.cameras.pop_back();
        chain.azimuths_rad.pop_back();
    }
    begin_behind_widest_gap(chain);
    return chain;
}

bool is_ring(const Chain& chain) {
    const double limit_rad =
        std::clamp(3 * chain.usual_gap_rad, 60.0 * kRadiansPerDegree, 150.0 * kRadiansPerDegree);
    return chain.cameras.size() >= 3 && chain.widest_gap_rad <= limit_rad;
}

/// Where the strip goes beyond an end camera: along the tangent of the circle about the centre, but
/// never towards the middle of the gap, where both ends would meet.
Eigen::Vector3d end_direction(const Eigen::Vector3d& camera_direction,
                              const Eigen::Vector3d& normal, const Eigen::Vector3d& gap,
                              double turn) {
    const Eigen::Vector3d tangent = turn * normal.cross(camera_direction).normalized();
    const Eigen::Vector3d across_gap = normal.cross(gap);
    const double side = camera_direction.dot(across_gap) > 0 ? 1.0 : -1.0;
    const double approach = std::min(0.0, side * tangent.dot(across_gap));
    const Eigen::Vector3d direction = tangent - approach * side * across_gap;
    return direction.norm() > 1e-6 ? direction.normalized() : gap;
}

/// The direction in the plane of the strip that lies in the middle of the widest gap.
Eigen::Vector3d gap_middle(const Chain& chain, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d first = normal.unitOrthogonal();
    const double azimuth_rad = chain.azimuths_rad.back() + chain.widest_gap_rad / 2;
    return std::cos(azimuth_rad) * first + std::sin(azimuth_rad) * normal.cross(first);
}

/// Appends centre + length * normal and centre - length * normal, both of one view.
void append_pair(CameraMesh& mesh, const Eigen::Vector3d& centre, int view_index,
                 const Eigen::Vector3d& stretch, bool is_virtual) {
    mesh.vertices.push_back({centre + stretch, view_index, is_virtual});
    mesh.vertices.push_back({centre - stretch, view_index, is_virtual});
}

/// The quadrilateral between the pairs `from` and `to`, which follow each other counter-clockwise
/// about the normal; its outside looks away from the centre.
void append_quadrilateral(CameraMesh& mesh, int from, int to) {
    const int from_above = 2 * from;
    const int from_below = 2 * from + 1;
    const int to_above = 2 * to;
    const int to_below = 2 * to + 1;
    mesh.faces.push_back({from_above, from_below, to_above});
    mesh.faces.push_back({to_above, from_below, to_below});
}

}  // namespace

LineStrip build_line_strip(const CameraStar& star, const Eigen::Vector3d& normal, double length) {
    const Chain chain = chain_by_azimuth(star, normal);
    LineStrip strip;
    strip.closed_ring = is_ring(chain);
    strip.hidden_cameras = static_cast<int>(star.axes.size() - chain.cameras.size());
    strip.mesh.scene_centre_in_world = star.centre_in_world;

    const Eigen::Vector3d stretch = length * normal;
    const Eigen::Vector3d gap = gap_middle(chain, normal);
    const auto append_end = [&](std::size_t camera, double turn) {
        const Eigen::Vector3d direction = end_direction(star.directions[camera], normal, gap, turn);
        append_pair(strip.mesh, star.axes[camera].centre_in_world + length * direction,
                    star.axes[camera].view_index, stretch, true);
    };
    if (!strip.closed_ring) append_end(chain.cameras.front(), -1.0);
    for (const std::size_t camera : chain.cameras) {
        append_pair(strip.mesh, star.axes[camera].centre_in_world, star.axes[camera].view_index,
                    stretch, false);
    }
    if (!strip.closed_ring) append_end(chain.cameras.back(), 1.0);

    const int pairs = static_cast<int>(strip.mesh.vertices.size() / 2);
    for (int pair = 0; pair + 1 < pairs; ++pair) append_quadrilateral(strip.mesh, pair, pair + 1);
    if (strip.closed_ring) append_quadrilateral(strip.mesh, pairs - 1, 0);
    return strip;
}

}  // namespace lumi
