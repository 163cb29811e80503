#include "pipeline/synth/hand_held_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "calib/capture/degrees.h"
#include "pipeline/synth/hashed_random.h"

namespace lumi {
namespace {

/// From -0.5 to 0.5 over `count` places; 0 when there is only one.
double centred_share(int index, int count) {
    return count < 2 ? 0.0 : static_cast<double>(index) / (count - 1) - 0.5;
}

/// Rows walked to and fro, so that neighbours in time are neighbours in space.
struct Place {
    int column = 0;
    int row = 0;
    int columns = 1;
};

Place place_in_rows(const HandHeldPath& path, int index) {
    Place place;
    place.columns = (path.count + path.rows - 1) / path.rows;
    place.row = index / place.columns;
    place.column = index % place.columns;
    if (place.row % 2 == 1) place.column = place.columns - 1 - place.column;
    return place;
}

Eigen::Vector3d around_target(const HandHeldPath& path, double azimuth_deg, double elevation_deg) {
    const double azimuth = azimuth_deg * kRadiansPerDegree;
    const double elevation = elevation_deg * kRadiansPerDegree;
    const Eigen::Vector3d direction(std::sin(azimuth) * std::cos(elevation),
                                    -std::cos(azimuth) * std::cos(elevation), std::sin(elevation));
    return path.target_in_world + path.distance * direction;
}

Eigen::Vector3d on_arc(const HandHeldPath& path, int index) {
    const Place place = place_in_rows(path, index);
    const double rise = 0.5 + (path.rows < 2 ? -0.5 : centred_share(place.row, path.rows));
    return around_target(
        path, path.azimuth_deg + path.span_deg * centred_share(place.column, place.columns),
        path.elevation_deg + rise * (path.top_elevation_deg - path.elevation_deg));
}

Eigen::Vector3d on_hemisphere(const HandHeldPath& path, int index) {
    const double share = (index + 0.5) / path.count;
    const double low = std::sin(path.elevation_deg * kRadiansPerDegree);
    const double high = std::sin(path.top_elevation_deg * kRadiansPerDegree);
    // Equal steps of height are equal areas of the sphere (Archimedes).
    const double elevation_deg = std::asin(low + share * (high - low)) / kRadiansPerDegree;
    return around_target(path, path.azimuth_deg + 360.0 * path.rows * share, elevation_deg);
}

/// A place on the plane through the middle of the path, square to the line of sight.
Eigen::Vector3d aside(const HandHeldPath& path, double right_share, double up_share) {
    const Eigen::Vector3d middle = around_target(path, path.azimuth_deg, path.elevation_deg);
    const Eigen::Quaterniond world_from_cam =
        looking_at(middle, path.target_in_world).rotation.conjugate();
    return middle + path.distance * (world_from_cam * Eigen::Vector3d(right_share, -up_share, 0));
}

Eigen::Vector3d on_grid(const HandHeldPath& path, int index) {
    const Place place = place_in_rows(path, index);
    const double step = path.length_share / std::max(place.columns - 1, 1);
    return aside(path, path.length_share * centred_share(place.column, place.columns),
                 step * (place.row - 0.5 * (path.rows - 1)));
}

Eigen::Vector3d eye_at(const HandHeldPath& path, int index) {
    const double along = centred_share(index, path.count);
    const Eigen::Vector3d middle = around_target(path, path.azimuth_deg, path.elevation_deg);
    switch (path.kind) {
        case PathKind::kArc:
            return on_arc(path, index);
        case PathKind::kRing:
            return around_target(path, path.azimuth_deg + 360.0 * index / path.count,
                                 path.elevation_deg);
        case PathKind::kHemisphere:
            return on_hemisphere(path, index);
        case PathKind::kGrid:
            return on_grid(path, index);
        case PathKind::kLine:
            return aside(path, path.length_share * along, 0.0);
        case PathKind::kForward:
            return middle + (along + 0.5) * path.length_share * (path.target_in_world - middle);
        case PathKind::kRotation:
            return middle;
    }
    return middle;
}

Eigen::Quaterniond turned(double degrees, const Eigen::Vector3d& axis) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * kRadiansPerDegree, axis));
}

Rigid3 pose_at(const HandHeldPath& path, int index, std::uint64_t seed) {
    HashedRandom random(seed, static_cast<std::uint64_t>(index));
    Eigen::Vector3d eye = eye_at(path, index);
    const Eigen::Vector3d shake(random.gaussian(), random.gaussian(), random.gaussian());
    if (path.kind != PathKind::kRotation) {
        eye += path.distance * path.position_jitter_share * shake;
    }
    const Rigid3 steady = looking_at(eye, path.target_in_world);
    const double pan_deg =
        path.kind == PathKind::kRotation ? path.span_deg * centred_share(index, path.count) : 0.0;
    const Eigen::Quaterniond cam_from_steady =
        turned(path.roll_jitter_deg * random.gaussian(), Eigen::Vector3d::UnitZ()) *
        turned(path.aim_jitter_deg * random.gaussian(), Eigen::Vector3d::UnitX()) *
        turned(path.aim_jitter_deg * random.gaussian() - pan_deg, Eigen::Vector3d::UnitY());
    const Eigen::Quaterniond rotation = (cam_from_steady * steady.rotation).normalized();
    return {rotation, -(rotation * eye)};
}

}  // namespace

Rigid3 looking_at(const Eigen::Vector3d& eye_in_world, const Eigen::Vector3d& target_in_world) {
    const Eigen::Vector3d forward = (target_in_world - eye_in_world).normalized();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    if (forward.cross(up).norm() < 1e-6) up = Eigen::Vector3d::UnitY();
    const Eigen::Vector3d right = forward.cross(up).normalized();
    Eigen::Matrix3d cam_from_world;
    cam_from_world << right.transpose(), forward.cross(right).transpose(), forward.transpose();
    const Eigen::Quaterniond rotation(cam_from_world);
    return {rotation, -(rotation * eye_in_world)};
}

std::vector<Rigid3> poses_along(const HandHeldPath& path, std::uint64_t seed) {
    std::vector<Rigid3> poses;
    for (int i = 0; i < path.count; ++i) {
        poses.push_back(pose_at(path, (i + path.start_at) % path.count, seed));
    }
    return poses;
}

}  // namespace lumi
