#pragma once

#include <Eigen/Core>
#include <limits>
#include <variant>

namespace lumi {

/// Signed distances are negative inside, in world units, and follow Inigo Quilez, "Distance
/// functions" (iquilezles.org/articles/distfunctions). All are exact but the ellipsoid's, which is
/// exact to first order at the surface.

/// Where a solid's own axes stand in the world.
struct Placement {
    Eigen::Vector3d centre_in_world = Eigen::Vector3d::Zero();
    Eigen::Matrix3d solid_from_world = Eigen::Matrix3d::Identity();  ///< Rotation.

    [[nodiscard]] Eigen::Vector3d to_solid(const Eigen::Vector3d& point_in_world) const {
        return solid_from_world * (point_in_world - centre_in_world);
    }
};

struct Ellipsoid {
    Placement placement;
    Eigen::Vector3d radii = Eigen::Vector3d::Ones();
};

/// A box with rounded edges; `rounding` is taken off the half sizes, so that the box keeps its
/// size.
struct Box {
    Placement placement;
    Eigen::Vector3d half_sizes = Eigen::Vector3d::Ones();
    double rounding = 0.0;
};

/// A cylinder along its own z axis with rounded rims.
struct Cylinder {
    Placement placement;
    double radius = 1.0;
    double half_height = 1.0;
    double rounding = 0.0;
};

/// A torus about its own z axis.
struct Torus {
    Placement placement;
    double ring_radius = 1.0;
    double tube_radius = 0.1;
};

/// The hull of two spheres. Their radii must differ by less than their distance.
struct TaperedCapsule {
    Eigen::Vector3d from_in_world = Eigen::Vector3d::Zero();
    Eigen::Vector3d to_in_world = Eigen::Vector3d::UnitZ();
    double from_radius = 1.0;
    double to_radius = 1.0;
};

using Solid = std::variant<Ellipsoid, Box, Cylinder, Torus, TaperedCapsule>;

[[nodiscard]] double signed_distance(const Solid& solid, const Eigen::Vector3d& point_in_world);

struct BoundingSphere {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double radius = std::numeric_limits<double>::infinity();
};

/// A sphere that holds the solid, not always the smallest.
[[nodiscard]] BoundingSphere bounding_sphere(const Solid& solid);

}  // namespace lumi
