#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/synth/ray.h"
#include "pipeline/synth/solid.h"

namespace lumi {

/// The most solids that one body may have.
inline constexpr std::size_t kMaxSolidsPerBody = 64;

/// One solid, or several that flow into one another, of one material.
class Body {
 public:
    /// `blend` is how far apart two surfaces begin to flow together, in world units; 0: not at all.
    Body(std::string name, int material_index, std::vector<Solid> solids, double blend,
         bool casts_shadow = true);

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] int material_index() const { return material_index_; }
    [[nodiscard]] bool casts_shadow() const { return casts_shadow_; }
    [[nodiscard]] const BoundingSphere& bounds() const { return bounds_; }
    /// A convex body casts no shadow on itself.
    [[nodiscard]] bool is_convex() const;

    /// Negative inside, in world units; a cubic smooth minimum over the solids (Quilez,
    /// iquilezles.org/articles/smin), which equals the plain minimum where they are `blend` apart.
    [[nodiscard]] double signed_distance(const Eigen::Vector3d& point_in_world) const;

    /// Distance along the ray to the first point on the surface within `span`, to about 1e-9 of the
    /// body's size. Empty when the ray passes by or starts inside.
    [[nodiscard]] std::optional<double> first_hit(const Ray& ray, RaySpan span) const;

    /// The share of a distant lamp along the ray that the body leaves uncovered: 0 in the umbra, 1
    /// beyond the penumbra. `softness` is the tangent of half the angle that the lamp fills.
    [[nodiscard]] double uncovered_share(const Ray& to_lamp, double softness) const;

    /// Of length one, outwards; for a point on the surface.
    [[nodiscard]] Eigen::Vector3d normal_at(const Eigen::Vector3d& point_in_world) const;

 private:
    /// Indices into `solids_`.
    using Subset = std::span<const std::uint8_t>;
    /// The solids that a ray comes near to, and the stretch of the ray where it does.
    struct NearSolids {
        std::array<std::uint8_t, kMaxSolidsPerBody> indices{};
        std::size_t count = 0;
        RaySpan span;
        [[nodiscard]] Subset subset() const { return {indices.data(), count}; }
    };

    [[nodiscard]] const Box* only_box() const;
    [[nodiscard]] NearSolids solids_near(const Ray& ray, RaySpan span, double margin) const;
    [[nodiscard]] double blended_distance(const Eigen::Vector3d& point_in_world,
                                          Subset solids) const;

    std::string name_;
    int material_index_;
    std::vector<Solid> solids_;
    std::vector<BoundingSphere> solid_bounds_;
    std::vector<std::uint8_t> all_solids_;
    double blend_;
    bool casts_shadow_;
    BoundingSphere bounds_;
};

}  // namespace lumi
