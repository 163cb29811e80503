#include "render/paths/path_past_border.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "render/paths/path_through_views.h"
#include "render/paths/pose_around.h"
#include "render/transfer/view_geometry.h"

namespace lumi {
namespace {

/// How much farther than its border the path leaves the capture.
constexpr double kBeyondBorder = 1.0 / 3;
constexpr double kLargestTurn_rad = 0.6;
/// How far behind a camera, of its distance, and before it, of the scene's near depth.
constexpr double kBehind = 0.3;
constexpr double kBefore = 1.0 / 3;

const Rigid3& pose_of(const Lumigraph& lumigraph, std::size_t view) {
    return lumigraph.views[view].cam_from_world;
}

Eigen::Vector3d direction_to(const Lumigraph& lumigraph, std::size_t view) {
    return (centre_in_world(pose_of(lumigraph, view)) - lumigraph.mesh.scene_centre_in_world)
        .normalized();
}

/// The view whose direction from the scene's centre is nearest to (-1: farthest from) another.
std::size_t extreme_view(const Lumigraph& lumigraph, const Eigen::Vector3d& direction,
                         double sign) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < lumigraph.views.size(); ++i)
        if (sign * direction.dot(direction_to(lumigraph, i)) >
            sign * direction.dot(direction_to(lumigraph, best)))
            best = i;
    return best;
}

Rigid3 moved(const Rigid3& cam_from_world, double forward) {
    Rigid3 pose = cam_from_world;
    pose.translation.z() -= forward;
    return pose;
}

std::vector<Rigid3> stations(const Lumigraph& lumigraph) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) mean += direction_to(lumigraph, i);
    const std::size_t middle = extreme_view(lumigraph, mean, 1);
    const std::size_t outermost = extreme_view(lumigraph, direction_to(lumigraph, middle), -1);
    const Eigen::Vector3d from = direction_to(lumigraph, middle);
    const Eigen::Vector3d to = direction_to(lumigraph, outermost);
    const std::size_t between = extreme_view(lumigraph, from + to, 1);
    const Eigen::Vector3d axis = from.cross(to);
    const double angle = std::atan2(axis.norm(), from.dot(to));
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(std::min(kBeyondBorder * angle, kLargestTurn_rad),
                          axis.norm() > 0 ? axis.normalized() : Eigen::Vector3d::UnitX()));
    const Rigid3& first = pose_of(lumigraph, middle);
    const double distance = (centre_in_world(first) - lumigraph.mesh.scene_centre_in_world).norm();
    const double near_depth = 1 / scene_inverse_depths(lumigraph).near;
    return {first,
            pose_of(lumigraph, between),
            pose_of(lumigraph, outermost),
            turned_about(lumigraph.mesh.scene_centre_in_world, turn, pose_of(lumigraph, outermost)),
            moved(first, -kBehind * distance),
            moved(first, kBefore * near_depth)};
}

}  // namespace

std::vector<Eye> path_past_border(const Lumigraph& lumigraph, int count, int width_px,
                                  int height_px) {
    const Camera camera = path_through_views(lumigraph, 1, width_px, height_px).front().camera;
    const std::vector<Rigid3> poses = stations(lumigraph);
    std::vector<Eye> path;
    for (int i = 0; i < count; ++i) {
        const double along = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
        const double place = along * static_cast<double>(poses.size() - 1);
        const auto from = std::min(static_cast<std::size_t>(place), poses.size() - 2);
        path.push_back({camera, pose_around(lumigraph.mesh.scene_centre_in_world, poses[from],
                                            poses[from + 1], place - static_cast<double>(from))});
    }
    return path;
}

}  // namespace lumi
