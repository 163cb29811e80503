#pragma once

#include <Eigen/Geometry>
#include <cstdio>
#include <random>
#include <string>

#include "calib/capture/capture.h"

namespace lumi {

/// A camera at `centre` that looks at `target`, upright (+y of the world is up).
[[nodiscard]] inline Rigid3 looking_at(const Eigen::Vector3d& centre,
                                       const Eigen::Vector3d& target) {
    const Eigen::Vector3d forward = (target - centre).normalized();
    const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitY()).normalized();
    Eigen::Matrix3d world_from_cam;
    world_from_cam << right, forward.cross(right), forward;
    Rigid3 cam_from_world;
    cam_from_world.rotation = Eigen::Quaterniond(world_from_cam).normalized().conjugate();
    cam_from_world.translation = -(cam_from_world.rotation * centre);
    return cam_from_world;
}

/// Views on a wavy arc around the origin, one camera, and points near the origin with exact tracks.
[[nodiscard]] inline Capture synthetic_capture(const Camera& camera, int views, int points,
                                               unsigned seed = 1) {
    Capture capture;
    capture.cameras = {camera};
    for (int i = 0; i < views; ++i) {
        char name[32];
        std::snprintf(name, sizeof(name), "view %03d.jpg", i);
        const double angle = 0.15 * i;
        const Eigen::Vector3d centre(4 * std::sin(angle), 0.5 * std::sin(2.3 * i),
                                     -4 * std::cos(angle));
        capture.views.push_back({name, 0, looking_at(centre, {0.1, 0.05, 0})});
    }
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> within(-0.6, 0.6);
    for (int i = 0; i < points; ++i) {
        ScenePoint point;
        point.position_in_world = {within(random), within(random), within(random)};
        point.color = {static_cast<std::uint8_t>(i), 100, 200};
        point.error_px = 0.25;
        for (int view = 0; view < views; ++view) {
            const Rigid3& pose = capture.views[static_cast<std::size_t>(view)].cam_from_world;
            const auto pixel = project(camera, pose * point.position_in_world);
            if (pixel && is_inside(camera, *pixel)) point.track.push_back({view, *pixel});
        }
        capture.points.push_back(point);
    }
    return capture;
}

}  // namespace lumi
