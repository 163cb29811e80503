#include "pipeline/synth/solid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

/// std::hypot guards against overflow, which costs more than all the rest here.
double length_of(double a, double b) { return std::sqrt(a * a + b * b); }

double distance_to(const Ellipsoid& ellipsoid, const Eigen::Vector3d& point_in_world) {
    const Eigen::Vector3d point = ellipsoid.placement.to_solid(point_in_world);
    const Eigen::Vector3d scaled = point.cwiseQuotient(ellipsoid.radii);
    const double scaled_norm = scaled.norm();
    const double gradient_norm = scaled.cwiseQuotient(ellipsoid.radii).norm();
    if (gradient_norm == 0.0) return -ellipsoid.radii.minCoeff();
    return scaled_norm * (scaled_norm - 1.0) / gradient_norm;
}

double distance_to(const Box& box, const Eigen::Vector3d& point_in_world) {
    const Eigen::Vector3d beyond = box.placement.to_solid(point_in_world).cwiseAbs() -
                                   box.half_sizes + Eigen::Vector3d::Constant(box.rounding);
    return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0) - box.rounding;
}

double distance_to(const Cylinder& cylinder, const Eigen::Vector3d& point_in_world) {
    const Eigen::Vector3d point = cylinder.placement.to_solid(point_in_world);
    const double beyond_radius = point.head<2>().norm() - cylinder.radius + cylinder.rounding;
    const double beyond_height = std::abs(point.z()) - cylinder.half_height + cylinder.rounding;
    return length_of(std::max(beyond_radius, 0.0), std::max(beyond_height, 0.0)) +
           std::min(std::max(beyond_radius, beyond_height), 0.0) - cylinder.rounding;
}

double distance_to(const Torus& torus, const Eigen::Vector3d& point_in_world) {
    const Eigen::Vector3d point = torus.placement.to_solid(point_in_world);
    const double from_ring = point.head<2>().norm() - torus.ring_radius;
    return length_of(from_ring, point.z()) - torus.tube_radius;
}

double distance_to(const TaperedCapsule& capsule, const Eigen::Vector3d& point_in_world) {
    const Eigen::Vector3d axis = capsule.to_in_world - capsule.from_in_world;
    const Eigen::Vector3d offset = point_in_world - capsule.from_in_world;
    const double length = axis.norm();
    const double along = offset.dot(axis) / length;
    const double across = std::sqrt(std::max(offset.squaredNorm() - along * along, 0.0));
    // In the plane of axis and point the outline is two circles and their common tangent.
    const double taper = (capsule.from_radius - capsule.to_radius) / length;
    const double slope = std::sqrt(1.0 - taper * taper);
    const double along_tangent = slope * along - taper * across;
    if (along_tangent <= 0.0) return length_of(along, across) - capsule.from_radius;
    if (along_tangent >= slope * length) {
        return length_of(along - length, across) - capsule.to_radius;
    }
    return taper * along + slope * across - capsule.from_radius;
}

BoundingSphere bounds_of(const Ellipsoid& ellipsoid) {
    return {ellipsoid.placement.centre_in_world, ellipsoid.radii.maxCoeff()};
}

BoundingSphere bounds_of(const Box& box) {
    return {box.placement.centre_in_world, box.half_sizes.norm()};
}

BoundingSphere bounds_of(const Cylinder& cylinder) {
    return {cylinder.placement.centre_in_world, std::hypot(cylinder.radius, cylinder.half_height)};
}

BoundingSphere bounds_of(const Torus& torus) {
    return {torus.placement.centre_in_world, torus.ring_radius + torus.tube_radius};
}

BoundingSphere bounds_of(const TaperedCapsule& capsule) {
    const Eigen::Vector3d axis = capsule.to_in_world - capsule.from_in_world;
    const double length = axis.norm();
    const double radius = 0.5 * (length + capsule.from_radius + capsule.to_radius);
    const double centre = (radius - capsule.from_radius) / length;
    return {capsule.from_in_world + centre * axis, radius};
}

}  // namespace

double signed_distance(const Solid& solid, const Eigen::Vector3d& point_in_world) {
    return std::visit([&](const auto& shape) { return distance_to(shape, point_in_world); }, solid);
}

BoundingSphere bounding_sphere(const Solid& solid) {
    return std::visit([](const auto& shape) { return bounds_of(shape); }, solid);
}

}  // namespace lumi
