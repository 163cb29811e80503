#include "meshing/cameras/close_ups.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "calib/capture/degrees.h"
#include "calib/work/median.h"
#include "meshing/cameras/border.h"
#include "meshing/cameras/camera_star.h"
#include "meshing/cameras/repair.h"

namespace lumi {
namespace {

constexpr double kFinerThanUsual = 2.0;
constexpr double kMostSeenOfUsual = 0.8;
constexpr std::size_t kLeastOthers = 3;
constexpr int kFinestLevel = 8;
/// So many views at most are asked how much of the scene they see.
constexpr std::size_t kViewsAsked = 50;
/// Views of one group look at this share of the lesser one's points at least.
constexpr double kLeastOverlap = 0.2;
const double kLeastCosine = std::cos(60 * kRadiansPerDegree);

constexpr double kRing_rad = 35 * kRadiansPerDegree;
constexpr int kRingPlaces = 12;
/// Ring vertices keep this share of the ring's radius from cameras, and this one from each other.
constexpr double kFreeOfCameras = 0.9;
constexpr double kFreeOfRing = 0.3;

/// Which scene points lie in a view's photograph.
std::vector<char> in_photograph(const Capture& capture, int view_index,
                                const std::vector<Eigen::Vector3d>& scene) {
    const View& view = capture.views[static_cast<std::size_t>(view_index)];
    const Camera& camera = camera_of(capture, view);
    std::vector<char> seen;
    for (const Eigen::Vector3d& point : scene) {
        const Eigen::Vector3d in_view = view.cam_from_world * point;
        const auto pixel = in_view.z() > 0 ? project(camera, in_view) : std::nullopt;
        seen.push_back(pixel && is_inside(camera, *pixel) ? 1 : 0);
    }
    return seen;
}

double count_of(const std::vector<char>& seen) {
    return static_cast<double>(std::count(seen.begin(), seen.end(), char{1}));
}

/// Size of a pixel on the scene, world units; 0 when the view sees none of it.
double footprint_of(const Capture& capture, const OpticalAxis& axis) {
    const View& view = capture.views[static_cast<std::size_t>(axis.view_index)];
    return axis.depth / focal_length_px(camera_of(capture, view)).mean();
}

bool see_the_same(const std::vector<char>& a, const std::vector<char>& b) {
    double common = 0;
    for (std::size_t i = 0; i < a.size(); ++i) common += a[i] && b[i] ? 1 : 0;
    return common > 0 && common >= kLeastOverlap * std::min(count_of(a), count_of(b));
}

struct CloseUp {
    int axis = 0;
    int level = 1;
    std::vector<char> seen;  ///< Which scene points.
};

/// Of the scene points how many the usual view sees: the median over some of the views.
double usual_count(const Capture& capture, const std::vector<OpticalAxis>& axes,
                   const std::vector<Eigen::Vector3d>& scene) {
    std::vector<double> counts;
    const std::size_t step = (axes.size() + kViewsAsked - 1) / kViewsAsked;
    for (std::size_t i = 0; i < axes.size(); i += step) {
        counts.push_back(count_of(in_photograph(capture, axes[i].view_index, scene)));
    }
    return quantile_of(std::move(counts), 0.5);
}

std::vector<CloseUp> close_ups_among(const Capture& capture, const std::vector<OpticalAxis>& axes,
                                     const std::vector<Eigen::Vector3d>& scene) {
    std::vector<double> footprints;
    for (const OpticalAxis& axis : axes) {
        if (axis.depth > 0) footprints.push_back(footprint_of(capture, axis));
    }
    if (footprints.empty()) return {};
    const double usual = quantile_of(std::move(footprints), 0.5);
    std::vector<CloseUp> close_ups;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const double footprint = footprint_of(capture, axes[i]);
        if (!(footprint > 0) || usual < kFinerThanUsual * footprint) continue;
        const int level = static_cast<int>(std::floor(std::log2(usual / footprint)));
        close_ups.push_back({static_cast<int>(i), std::min(level, kFinestLevel), {}});
    }
    // Seldom are there any, and then few.
    if (close_ups.empty() || 2 * close_ups.size() > axes.size()) return {};
    const double most_seen = kMostSeenOfUsual * usual_count(capture, axes, scene);
    for (CloseUp& close_up : close_ups) {
        const OpticalAxis& axis = axes[static_cast<std::size_t>(close_up.axis)];
        close_up.seen = in_photograph(capture, axis.view_index, scene);
    }
    std::erase_if(close_ups, [&](const CloseUp& close_up) {
        const double count = count_of(close_up.seen);
        return count == 0 || count > most_seen;
    });
    return close_ups;
}

/// The places of the ring, each with the camera that stands nearest to it.
struct RingPlace {
    Eigen::Vector3d direction;
    std::size_t camera;
};

std::vector<RingPlace> ring_around(const CameraStar& star) {
    const auto within = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, double share) {
        return a.dot(b) > std::cos(share * kRing_rad);
    };
    std::vector<RingPlace> ring;
    for (std::size_t camera = 0; camera < star.directions.size(); ++camera) {
        const Eigen::Vector3d& axis = star.directions[camera];
        const Eigen::Vector3d aside = axis.unitOrthogonal();
        for (int place = 0; place < kRingPlaces; ++place) {
            const Eigen::AngleAxisd turn(2 * std::numbers::pi * place / kRingPlaces, axis);
            const Eigen::Vector3d direction =
                std::cos(kRing_rad) * axis + std::sin(kRing_rad) * (turn * aside);
            const bool among_cameras = std::any_of(
                star.directions.begin(), star.directions.end(),
                [&](const auto& other) { return within(direction, other, kFreeOfCameras); });
            const bool taken = std::any_of(ring.begin(), ring.end(), [&](const auto& other) {
                return within(direction, other.direction, kFreeOfRing);
            });
            if (!among_cameras && !taken) ring.push_back({direction, camera});
        }
    }
    return ring;
}

}  // namespace

std::vector<CloseUpGroup> find_close_ups(const Capture& capture,
                                         const std::vector<OpticalAxis>& axes,
                                         const std::vector<Eigen::Vector3d>& scene_in_world) {
    const std::vector<CloseUp> close_ups = close_ups_among(capture, axes, scene_in_world);
    if (axes.size() < kLeastOthers + close_ups.size()) return {};
    std::vector<CloseUpGroup> groups;
    std::vector<const std::vector<char>*> seen_by_first;
    for (const CloseUp& close_up : close_ups) {
        const Eigen::Vector3d& direction =
            axes[static_cast<std::size_t>(close_up.axis)].direction_in_world;
        std::size_t group = 0;
        for (; group < groups.size(); ++group) {
            const auto first = static_cast<std::size_t>(groups[group].axes.front());
            if (groups[group].level == close_up.level &&
                axes[first].direction_in_world.dot(direction) >= kLeastCosine &&
                see_the_same(*seen_by_first[group], close_up.seen)) {
                break;
            }
        }
        if (group == groups.size()) {
            groups.push_back({close_up.level, {}});
            seen_by_first.push_back(&close_up.seen);
        }
        groups[group].axes.push_back(close_up.axis);
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const auto& a, const auto& b) { return a.level < b.level; });
    return groups;
}

CameraMesh close_up_shell(const std::vector<OpticalAxis>& group_axes,
                          const std::vector<Eigen::Vector3d>& seen_in_world) {
    const CameraStar star = camera_star(group_axes, estimate_scene_centre(group_axes));
    CameraMesh shell;
    shell.construction = MeshConstruction::kOpen;
    shell.scene_centre_in_world = star.centre_in_world;
    std::vector<Eigen::Vector3d> directions = star.directions;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < star.axes.size(); ++i) {
        shell.vertices.push_back({star.axes[i].centre_in_world, star.axes[i].view_index});
        mean += star.directions[i];
    }
    for (const RingPlace& place : ring_around(star)) {
        directions.push_back(place.direction);
        shell.vertices.push_back(
            {star.centre_in_world + star.distances[place.camera] * place.direction,
             star.axes[place.camera].view_index, true});
    }
    shell.faces = open_triangulation(directions, -mean.normalized());
    const auto centre_of_view = [&](int view) {
        const auto axis = std::find_if(group_axes.begin(), group_axes.end(),
                                       [&](const auto& one) { return one.view_index == view; });
        return axis->centre_in_world;
    };
    static_cast<void>(repair_kernel(shell, {seen_in_world, centre_of_view}));
    return shell;
}

std::vector<Eigen::Vector3d> points_in_view(const Capture& capture,
                                            const std::vector<OpticalAxis>& group_axes,
                                            const std::vector<Eigen::Vector3d>& scene_in_world) {
    std::vector<char> seen(scene_in_world.size(), 0);
    for (const OpticalAxis& axis : group_axes) {
        const std::vector<char> here = in_photograph(capture, axis.view_index, scene_in_world);
        for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = seen[i] || here[i] ? 1 : 0;
    }
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (seen[i]) points.push_back(scene_in_world[i]);
    }
    return points;
}

}  // namespace lumi
