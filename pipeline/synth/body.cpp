#include "pipeline/synth/body.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "pipeline/synth/sphere_tracing.h"

namespace lumi {
namespace {

double smooth_minimum(double a, double b, double blend) {
    if (blend == 0.0) return std::min(a, b);
    const double overlap = std::max(blend - std::abs(a - b), 0.0) / blend;
    return std::min(a, b) - overlap * overlap * overlap * blend / 6.0;
}

BoundingSphere bounds_of_all(const std::vector<BoundingSphere>& spheres, double margin) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;
    for (const BoundingSphere& sphere : spheres) {
        low = low.cwiseMin((sphere.centre.array() - sphere.radius).matrix());
        high = high.cwiseMax((sphere.centre.array() + sphere.radius).matrix());
    }
    BoundingSphere result{0.5 * (low + high), 0.0};
    for (const BoundingSphere& sphere : spheres) {
        result.radius =
            std::max(result.radius, (sphere.centre - result.centre).norm() + sphere.radius);
    }
    result.radius += margin;
    return result;
}

RaySpan within_sphere(const Ray& ray, const BoundingSphere& sphere, RaySpan span) {
    const Eigen::Vector3d to_centre = sphere.centre - ray.origin;
    const double middle = to_centre.dot(ray.direction);
    const double squared_half =
        sphere.radius * sphere.radius - (to_centre.squaredNorm() - middle * middle);
    if (squared_half < 0.0) return {0.0, -1.0};
    const double half = std::sqrt(squared_half);
    return {std::max(span.near, middle - half), std::min(span.far, middle + half)};
}

/// The stretch of the ray within a box without its rounding: the slab method (Kay and Kajiya 1986).
RaySpan within_box(const Ray& ray, const Box& box, RaySpan span) {
    const Eigen::Vector3d origin = box.placement.to_solid(ray.origin);
    const Eigen::Vector3d direction = box.placement.solid_from_world * ray.direction;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (std::abs(origin[axis]) > box.half_sizes[axis]) return {0.0, -1.0};
            continue;
        }
        const double a = (-box.half_sizes[axis] - origin[axis]) / direction[axis];
        const double b = (box.half_sizes[axis] - origin[axis]) / direction[axis];
        span.near = std::max(span.near, std::min(a, b));
        span.far = std::min(span.far, std::max(a, b));
    }
    return span;
}

Eigen::Vector3d normal_of_sharp_box(const Box& box, const Eigen::Vector3d& point_in_world) {
    const Eigen::Vector3d point = box.placement.to_solid(point_in_world);
    Eigen::Index axis = 0;
    (point.cwiseAbs() - box.half_sizes).maxCoeff(&axis);
    return std::copysign(1.0, point[axis]) * box.placement.solid_from_world.row(axis).transpose();
}

}  // namespace

Body::Body(std::string name, int material_index, std::vector<Solid> solids, double blend,
           bool casts_shadow)
    : name_(std::move(name)),
      material_index_(material_index),
      solids_(std::move(solids)),
      blend_(blend),
      casts_shadow_(casts_shadow) {
    assert(!solids_.empty() && solids_.size() <= kMaxSolidsPerBody);
    for (const Solid& solid : solids_) solid_bounds_.push_back(bounding_sphere(solid));
    all_solids_.resize(solids_.size());
    std::iota(all_solids_.begin(), all_solids_.end(), std::uint8_t{0});
    bounds_ = bounds_of_all(solid_bounds_, solids_.size() == 1 ? 0.0 : blend_);
}

bool Body::is_convex() const {
    return solids_.size() == 1 && !std::holds_alternative<Torus>(solids_.front());
}

const Box* Body::only_box() const {
    return solids_.size() == 1 ? std::get_if<Box>(&solids_.front()) : nullptr;
}

double Body::blended_distance(const Eigen::Vector3d& point_in_world, Subset solids) const {
    double distance = std::numeric_limits<double>::infinity();
    for (const std::uint8_t i : solids) {
        // A solid whose bounds are further than this changes nothing.
        const double reach = distance + blend_ + solid_bounds_[i].radius;
        if ((point_in_world - solid_bounds_[i].centre).squaredNorm() > reach * std::abs(reach)) {
            continue;
        }
        const double other = lumi::signed_distance(solids_[i], point_in_world);
        distance = std::isinf(distance) ? other : smooth_minimum(distance, other, blend_);
    }
    return distance;
}

double Body::signed_distance(const Eigen::Vector3d& point_in_world) const {
    return blended_distance(point_in_world, all_solids_);
}

std::optional<double> Body::first_hit(const Ray& ray, RaySpan span) const {
    const Box* box = only_box();
    const RaySpan inside =
        box != nullptr ? within_box(ray, *box, span) : within_sphere(ray, bounds_, span);
    if (inside.empty()) return std::nullopt;
    if (box != nullptr && box->rounding == 0.0) {
        // A ray that is in the box from the start of its span on begins inside.
        return inside.near > span.near ? std::optional(inside.near) : std::nullopt;
    }
    const NearSolids near = solids_near(ray, inside, 0.0);
    if (near.count == 0) return std::nullopt;
    return sphere_trace(near.span, bounds_.radius, [&](double place) {
        return blended_distance(ray.at(place), near.subset());
    });
}

Body::NearSolids Body::solids_near(const Ray& ray, RaySpan span, double margin) const {
    // A join reaches as far as `blend` and bulges by a sixth of it: solids further away shape no
    // surface on the ray.
    if (solids_.size() > 1) margin += 1.5 * blend_;
    NearSolids near;
    near.span = {span.far, span.near};
    for (const std::uint8_t i : all_solids_) {
        const BoundingSphere& bounds = solid_bounds_[i];
        const RaySpan inside = within_sphere(ray, {bounds.centre, bounds.radius + margin}, span);
        if (inside.empty()) continue;
        near.indices[near.count++] = i;
        near.span.near = std::min(near.span.near, inside.near);
        near.span.far = std::max(near.span.far, inside.far);
    }
    return near;
}

/// From the closest passage of the ray (Quilez, iquilezles.org/articles/rmshadows).
double Body::uncovered_share(const Ray& to_lamp, double softness) const {
    const double end = (bounds_.centre - to_lamp.origin).dot(to_lamp.direction) + bounds_.radius;
    if (end <= 0.0) return 1.0;
    const double penumbra = softness * end;
    const RaySpan whole{1e-3 * bounds_.radius, end + penumbra};
    const RaySpan inside =
        within_sphere(to_lamp, {bounds_.centre, bounds_.radius + penumbra}, whole);
    if (inside.empty()) return 1.0;
    const NearSolids near = solids_near(to_lamp, inside, penumbra);
    double uncovered = 1.0;
    double place = near.span.near;
    for (int step = 0; step < 64 && place < near.span.far; ++step) {
        const double distance = blended_distance(to_lamp.at(place), near.subset());
        uncovered = std::min(uncovered, 0.5 + 0.5 * distance / (softness * place));
        if (uncovered <= 0.0) return 0.0;
        place += std::clamp(0.9 * std::abs(distance), 0.02 * bounds_.radius, bounds_.radius);
    }
    return uncovered * uncovered * (3.0 - 2.0 * uncovered);
}

Eigen::Vector3d Body::normal_at(const Eigen::Vector3d& point_in_world) const {
    if (const Box* box = only_box(); box != nullptr && box->rounding == 0.0) {
        return normal_of_sharp_box(*box, point_in_world);
    }
    // Differences at the corners of a tetrahedron: four evaluations, and exact for a plane.
    static const std::array<Eigen::Vector3d, 4> kCorners{
        Eigen::Vector3d(1, -1, -1), Eigen::Vector3d(-1, -1, 1), Eigen::Vector3d(-1, 1, -1),
        Eigen::Vector3d(1, 1, 1)};
    const double step = 1e-5 * bounds_.radius;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : kCorners) {
        gradient += corner * signed_distance(point_in_world + step * corner);
    }
    return gradient.normalized();
}

}  // namespace lumi
