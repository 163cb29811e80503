#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/synth/body.h"
#include "pipeline/synth/material.h"
#include "pipeline/synth/ray.h"

namespace lumi {

/// Where the light comes from: one large lamp far away, and the room all around.
struct Lighting {
    Eigen::Vector3d towards_lamp{-0.5, -0.6, 0.7};  ///< Of any length above 0.
    LinearColor lamp_color = LinearColor::Constant(0.75f);
    LinearColor sky_color = LinearColor::Constant(0.45f);     ///< From above (+z).
    LinearColor ground_color = LinearColor::Constant(0.25f);  ///< From below.
    double lamp_softness = 0.15;  ///< Tangent of half the angle the lamp fills; shadows' soft rim.
    double contact_radius = 0.1;  ///< Corners darken within this distance, world units; 0: never.
};

/// What is photographed. The world's z axis points up.
struct Scene {
    std::vector<Material> materials;
    std::vector<Body> bodies;
    Lighting lighting;
};

/// What a ray meets first.
struct Hit {
    double distance = 0.0;  ///< Along the ray, world units.
    int body_index = 0;
};

[[nodiscard]] std::optional<Hit> first_hit(const Scene& scene, const Ray& ray);
/// Among these bodies only.
[[nodiscard]] std::optional<Hit> first_hit(const Scene& scene, const Ray& ray,
                                           std::span<const int> body_indices);

/// The bodies that rays within a cone may meet: all of them, and a few more.
[[nodiscard]] std::vector<int> bodies_in_cone(const Scene& scene, const Ray& axis,
                                              double half_angle);

/// True when no body is between an eye in the open and a point, which may lie on a surface.
[[nodiscard]] bool is_visible_from(const Scene& scene, const Eigen::Vector3d& eye_in_world,
                                   const Eigen::Vector3d& point_in_world);

/// Negative inside a body, world units.
[[nodiscard]] double signed_distance(const Scene& scene, const Eigen::Vector3d& point_in_world);

/// A place on a surface.
struct SurfacePlace {
    Eigen::Vector3d point_in_world = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    int body_index = 0;
};

/// How much of the light arrives at a place, whoever looks at it.
struct Illumination {
    double lamp_visibility = 1.0;  ///< The share of the lamp that is not covered.
    double openness = 1.0;         ///< The share of the room's light that is not covered.
};

/// Soft shadows and darker corners. Costs more than all the rest of a sample.
[[nodiscard]] Illumination illumination_at(const Scene& scene, const SurfacePlace& place);

/// The light that leaves a place towards the eye: Lambert's law, and the material's highlight
/// (Blinn 1977). `footprint` is the sample's width on the surface, world units.
[[nodiscard]] LinearColor light_towards_eye(const Scene& scene, const SurfacePlace& place,
                                            const Illumination& illumination,
                                            const Eigen::Vector3d& towards_eye, double footprint);

}  // namespace lumi
