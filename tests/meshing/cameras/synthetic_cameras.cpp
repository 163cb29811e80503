#include "tests/meshing/cameras/synthetic_cameras.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "calib/capture/rigid3.h"

namespace lumi {

Capture capture_of(const Points& centres, const Eigen::Vector3d& target, const Points& points) {
    Capture capture;
    capture.cameras.push_back(pinhole_camera(640, 480, 500));
    for (const Eigen::Vector3d& centre : centres) {
        const Eigen::Vector3d offset = target - centre;
        const Eigen::Vector3d axis =
            offset.norm() > 0 ? Eigen::Vector3d(offset.normalized()) : Eigen::Vector3d::UnitZ();
        View view;
        view.name = "view" + std::to_string(capture.views.size());
        view.cam_from_world.rotation = turn_between(axis, Eigen::Vector3d::UnitZ());
        view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
        capture.views.push_back(view);
    }
    for (const Eigen::Vector3d& position : points) {
        ScenePoint point;
        point.position_in_world = position;
        for (const int view : all_views(capture))
            point.track.push_back({view, Eigen::Vector2d::Zero()});
        capture.points.push_back(point);
    }
    return capture;
}

Eigen::Vector3d random_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double x = normal(random);
    const double y = normal(random);
    return Eigen::Vector3d(x, y, normal(random)).normalized();
}

Points points_in_ball(int count, const Eigen::Vector3d& centre, double radius,
                      std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0, 1);
    Points points;
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector3d direction = random_direction(random);
        points.push_back(centre + radius * std::cbrt(uniform(random)) * direction);
    }
    return points;
}

Points sphere_directions(int count, double least_z) {
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    Points directions;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - 2 * (i + 0.5) / count;
        const double radius = std::sqrt(1 - z * z);
        const double azimuth = golden_angle * i;
        if (z >= least_z) {
            directions.emplace_back(radius * std::cos(azimuth), radius * std::sin(azimuth), z);
        }
    }
    return directions;
}

int entering_faces(const CameraMesh& mesh, const Eigen::Vector3d& point,
                   const Eigen::Vector3d& direction) {
    int count = 0;
    for (const CameraMesh::Face& face : mesh.faces) {
        const Eigen::Vector3d sides = side_products(mesh, face, point, direction);
        if (sides.minCoeff() >= 0 && sides.sum() > 0) ++count;
    }
    return count;
}

std::vector<double> weights_by_view(const RayWeights& weights, std::size_t views) {
    std::vector<double> result(views, 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        result[static_cast<std::size_t>(weights.view_indices[i])] += weights.weights[i];
    }
    return result;
}

}  // namespace lumi
