#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <string>

#include "pipeline/synth/read_vectors.h"
#include "pipeline/synth/scene_description.h"

namespace lumi {
namespace {

/// `at`, and `turn_deg`: about x, then y, then z, all of them the world's axes.
Placement read_placement(const ConfigSection& section) {
    const Eigen::Vector3d turn =
        read_vector(section, "turn_deg", Eigen::Vector3d::Zero()) * (std::numbers::pi / 180.0);
    const Eigen::Matrix3d world_from_solid =
        (Eigen::AngleAxisd(turn.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(turn.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(turn.x(), Eigen::Vector3d::UnitX()))
            .toRotationMatrix();
    return {read_vector(section, "at", Eigen::Vector3d::Zero()), world_from_solid.transpose()};
}

Eigen::Vector3d read_sizes(const ConfigSection& section, const std::string& key) {
    const Eigen::Vector3d sizes = read_vector(section, key, Eigen::Vector3d::Ones());
    if (sizes.minCoeff() <= 0) section.refuse(key, "three numbers above 0");
    return sizes;
}

double read_rounding(const ConfigSection& section, double least_half_size) {
    const double rounding = read_not_negative(section, "rounding", 0.0);
    if (rounding > least_half_size) {
        section.refuse("rounding", "no more than half of the smallest size");
    }
    return rounding;
}

Solid read_box(const ConfigSection& section) {
    const Eigen::Vector3d half_sizes = 0.5 * read_sizes(section, "size");
    return Box{read_placement(section), half_sizes, read_rounding(section, half_sizes.minCoeff())};
}

Solid read_cylinder(const ConfigSection& section) {
    const double radius = read_positive(section, "radius", 1.0);
    const double half_height = 0.5 * read_positive(section, "height", 1.0);
    return Cylinder{read_placement(section), radius, half_height,
                    read_rounding(section, std::min(radius, half_height))};
}

Solid read_torus(const ConfigSection& section) {
    return Torus{read_placement(section), read_positive(section, "ring_radius", 1.0),
                 read_positive(section, "tube_radius", 0.1)};
}

Solid read_capsule(const ConfigSection& section) {
    TaperedCapsule capsule;
    capsule.from_in_world = read_vector(section, "from", capsule.from_in_world);
    capsule.to_in_world = read_vector(section, "to", capsule.to_in_world);
    capsule.from_radius = read_positive(section, "from_radius", capsule.from_radius);
    capsule.to_radius = read_positive(section, "to_radius", capsule.from_radius);
    const double length = (capsule.to_in_world - capsule.from_in_world).norm();
    if (std::abs(capsule.from_radius - capsule.to_radius) >= length) {
        section.refuse("to_radius", "radii that differ by less than the distance of the ends");
    }
    return capsule;
}

}  // namespace

Solid read_solid(const ConfigSection& section) {
    const std::string shape = section.text("shape", "");
    if (shape == "ellipsoid")
        return Ellipsoid{read_placement(section), read_sizes(section, "radii")};
    if (shape == "box") return read_box(section);
    if (shape == "cylinder") return read_cylinder(section);
    if (shape == "torus") return read_torus(section);
    if (shape == "capsule") return read_capsule(section);
    section.refuse("shape", "ellipsoid, box, cylinder, torus or capsule");
}

}  // namespace lumi
