#include "pipeline/synth/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumi {

namespace {

void keep_nearer(const Scene& scene, const Ray& ray, int body_index, std::optional<Hit>& nearest) {
    const RaySpan span{0.0, nearest ? nearest->distance : std::numeric_limits<double>::infinity()};
    const auto distance = scene.bodies[static_cast<std::size_t>(body_index)].first_hit(ray, span);
    if (distance) nearest = Hit{*distance, body_index};
}

}  // namespace

std::optional<Hit> first_hit(const Scene& scene, const Ray& ray) {
    std::optional<Hit> nearest;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        keep_nearer(scene, ray, static_cast<int>(i), nearest);
    }
    return nearest;
}

std::optional<Hit> first_hit(const Scene& scene, const Ray& ray,
                             std::span<const int> body_indices) {
    std::optional<Hit> nearest;
    for (const int body_index : body_indices) keep_nearer(scene, ray, body_index, nearest);
    return nearest;
}

std::vector<int> bodies_in_cone(const Scene& scene, const Ray& axis, double half_angle) {
    std::vector<int> indices;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BoundingSphere& bounds = scene.bodies[i].bounds();
        const Eigen::Vector3d to_centre = bounds.centre - axis.origin;
        const double distance = to_centre.norm();
        const bool is_around_apex = distance <= bounds.radius;
        if (!is_around_apex) {
            const double cosine = to_centre.dot(axis.direction) / distance;
            const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
            if (angle > half_angle + std::asin(bounds.radius / distance)) continue;
        }
        indices.push_back(static_cast<int>(i));
    }
    return indices;
}

bool is_visible_from(const Scene& scene, const Eigen::Vector3d& eye_in_world,
                     const Eigen::Vector3d& point_in_world) {
    const double distance = (point_in_world - eye_in_world).norm();
    const Ray ray{eye_in_world, (point_in_world - eye_in_world) / distance};
    // Ends before the point, whose own surface hides nothing.
    const RaySpan between{0.0, (1.0 - 1e-6) * distance};
    return std::none_of(scene.bodies.begin(), scene.bodies.end(),
                        [&](const Body& body) { return body.first_hit(ray, between); });
}

double signed_distance(const Scene& scene, const Eigen::Vector3d& point_in_world) {
    double distance = std::numeric_limits<double>::infinity();
    for (const Body& body : scene.bodies) {
        distance = std::min(distance, body.signed_distance(point_in_world));
    }
    return distance;
}

}  // namespace lumi
