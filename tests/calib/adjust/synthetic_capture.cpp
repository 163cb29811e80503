#include "tests/calib/adjust/synthetic_capture.h"

#include <cmath>
#include <numbers>
#include <random>

namespace lumi {
namespace {

Rigid3 looking_at_origin(const Eigen::Vector3d& centre) {
    const Eigen::Vector3d forward = -centre.normalized();
    const Eigen::Vector3d right = Eigen::Vector3d::UnitY().cross(forward).normalized();
    Eigen::Matrix3d world_from_cam;
    world_from_cam << right, forward.cross(right), forward;
    const Eigen::Quaterniond cam_from_world(Eigen::Matrix3d(world_from_cam.transpose()));
    return {cam_from_world, -(cam_from_world * centre)};
}

}  // namespace

Capture synthetic_capture(const Camera& camera, const SyntheticCaptureOptions& options) {
    std::mt19937 random(options.seed);
    std::uniform_real_distribution<double> inside(-1.0, 1.0);
    std::normal_distribution<double> gaussian(0.0, 1.0);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Capture capture;
    capture.cameras = {camera};
    for (int index = 0; index < options.views; ++index) {
        const double share = options.views == 1 ? 0 : index / (options.views - 1.0) - 0.5;
        const double angle = share * options.arc_deg * std::numbers::pi / 180.0;
        // Heights alternate, so that the centres do not lie in one plane.
        const Eigen::Vector3d centre(options.arc_radius * std::sin(angle),
                                     0.3 * (index % 3 - 1) * options.arc_radius / 4.0,
                                     -options.arc_radius * std::cos(angle));
        capture.views.push_back(
            {"view" + std::to_string(100 + index) + ".png", 0, looking_at_origin(centre)});
    }
    for (int index = 0; index < options.points; ++index) {
        ScenePoint point;
        point.position_in_world = {inside(random), inside(random),
                                   options.depth_of_cloud * inside(random)};
        for (int view = 0; view < options.views; ++view) {
            const Rigid3& pose = capture.views[static_cast<std::size_t>(view)].cam_from_world;
            const auto pixel = project(camera, pose * point.position_in_world);
            if (!pixel || !is_inside(camera, *pixel)) continue;
            Eigen::Vector2d seen = *pixel;
            seen += options.noise_px * Eigen::Vector2d(gaussian(random), gaussian(random));
            if (unit(random) < options.outlier_share) {
                const double direction = 2 * std::numbers::pi * unit(random);
                seen += (20.0 + 100.0 * unit(random)) *
                        Eigen::Vector2d(std::cos(direction), std::sin(direction));
            }
            point.track.push_back({view, seen});
        }
        if (point.track.size() >= 2) capture.points.push_back(std::move(point));
    }
    return capture;
}

}  // namespace lumi
