#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/synth/scene.h"

namespace lumi {
namespace {

constexpr double kHighlightExponent = 30.0;

double lamp_visibility(const Scene& scene, const SurfacePlace& place) {
    const Lighting& lighting = scene.lighting;
    const Eigen::Vector3d towards_lamp = lighting.towards_lamp.normalized();
    if (place.normal.dot(towards_lamp) <= 0.0) return 0.0;
    double visibility = 1.0;
    for (std::size_t i = 0; i < scene.bodies.size() && visibility > 0.0; ++i) {
        const Body& body = scene.bodies[i];
        const bool is_own = static_cast<int>(i) == place.body_index;
        if (!body.casts_shadow() || (is_own && body.is_convex())) continue;
        const double lift = is_own ? 1e-3 * body.bounds().radius : 0.0;
        const Ray to_lamp{place.point_in_world + lift * place.normal, towards_lamp};
        visibility = std::min(visibility, body.uncovered_share(to_lamp, lighting.lamp_softness));
    }
    return visibility;
}

/// How much of the light at a place one body keeps out: ambient occlusion from a few heights above
/// it (Evans, "Fast approximations for global illumination on dynamic scenes", SIGGRAPH course
/// 2006).
double covered_by(const Body& body, const SurfacePlace& place, double radius) {
    constexpr std::array<double, 4> kHeights{0.08, 0.25, 0.55, 1.0};
    constexpr std::array<double, 4> kWeights{0.28, 0.3, 0.26, 0.16};
    // A distance changes by no more than the way that is gone.
    const double reach = 2.0 * radius;
    const BoundingSphere& bounds = body.bounds();
    const double squared_reach = (reach + bounds.radius) * (reach + bounds.radius);
    if ((place.point_in_world - bounds.centre).squaredNorm() > squared_reach) return 0.0;
    if (body.signed_distance(place.point_in_world) > reach) return 0.0;
    double covered = 0.0;
    for (std::size_t i = 0; i < kHeights.size(); ++i) {
        const double height = kHeights[i] * radius;
        const double distance = body.signed_distance(place.point_in_world + height * place.normal);
        covered += kWeights[i] * (1.0 - std::clamp(distance / height, 0.0, 1.0));
    }
    return covered;
}

double openness(const Scene& scene, const SurfacePlace& place) {
    const double radius = scene.lighting.contact_radius;
    if (radius == 0.0) return 1.0;
    double open = 1.0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        if (static_cast<int>(i) == place.body_index && body.is_convex()) continue;
        open *= 1.0 - covered_by(body, place, radius);
    }
    return open;
}

}  // namespace

Illumination illumination_at(const Scene& scene, const SurfacePlace& place) {
    return {lamp_visibility(scene, place), openness(scene, place)};
}

LinearColor light_towards_eye(const Scene& scene, const SurfacePlace& place,
                              const Illumination& illumination, const Eigen::Vector3d& towards_eye,
                              double footprint) {
    const Lighting& lighting = scene.lighting;
    const Body& body = scene.bodies[static_cast<std::size_t>(place.body_index)];
    const Material& material = scene.materials[static_cast<std::size_t>(body.material_index())];
    const LinearColor albedo = albedo_at(material, place.point_in_world, place.normal, footprint);

    const Eigen::Vector3d towards_lamp = lighting.towards_lamp.normalized();
    const double lamp =
        illumination.lamp_visibility * std::max(place.normal.dot(towards_lamp), 0.0);
    const auto upwards = static_cast<float>(0.5 + 0.5 * place.normal.z());
    const LinearColor room =
        lighting.ground_color + upwards * (lighting.sky_color - lighting.ground_color);
    const LinearColor received = lighting.lamp_color * static_cast<float>(lamp) +
                                 room * static_cast<float>(illumination.openness);

    if (material.gloss == 0.0) return albedo.cwiseProduct(received);
    const Eigen::Vector3d half_way = (towards_lamp + towards_eye).normalized();
    const double highlight =
        material.gloss * illumination.lamp_visibility *
        std::pow(std::max(place.normal.dot(half_way), 0.0), kHighlightExponent);
    return albedo.cwiseProduct(received) + static_cast<float>(highlight) * lighting.lamp_color;
}

}  // namespace lumi
