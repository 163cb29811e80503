#include "pipeline/hazards/hazard_scenery.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

namespace lumi {
namespace {

LinearColor random_color(HashedRandom& random) {
    return linear_from_srgb({static_cast<float>(random.between(0.2, 0.95)),
                             static_cast<float>(random.between(0.2, 0.95)),
                             static_cast<float>(random.between(0.2, 0.95))});
}

}  // namespace

Material random_material(HashedRandom& random) {
    constexpr std::array<Pattern, 4> kPatterns{Pattern::kStone, Pattern::kMarble, Pattern::kBricks,
                                               Pattern::kWood};
    Material material;
    material.pattern = kPatterns[random.below(kPatterns.size())];
    for (LinearColor& color : material.colors) color = random_color(random);
    material.feature_size = random.between(0.35, 0.8);
    material.detail_contrast = random.between(0.4, 0.6);
    material.detail_size = random.between(0.2, 0.35);
    material.seed = static_cast<std::uint32_t>(random.word());
    return material;
}

Solid box_at(const Eigen::Vector3d& centre, const Eigen::Vector3d& size, double turn_rad) {
    return Box{{centre, Eigen::AngleAxisd(-turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix()},
               0.5 * size,
               0.0};
}

HazardScenery::HazardScenery(std::uint64_t seed) : random_(seed, 1) {
    scene_.lighting.towards_lamp = {random_.between(-0.8, 0.8), -0.8, 1.0};
    scene_.lighting.contact_radius = 0.0;
}

void HazardScenery::add(const std::string& name, Solid solid, const Material& material,
                        bool casts_shadow) {
    scene_.materials.push_back(material);
    scene_.bodies.emplace_back(name, static_cast<int>(scene_.materials.size()) - 1,
                               std::vector{std::move(solid)}, 0.0, casts_shadow);
}

void HazardScenery::add_floor() {
    add("floor", box_at({0, 0, -0.1}, {40, 40, 0.2}), random_material(random_), false);
}

void HazardScenery::add_wall() {
    add("wall", box_at({0, kWallY + 0.2, 5}, {40, 0.4, 12}), random_material(random_), false);
}

void HazardScenery::add_objects() {
    for (int index = 0; index < 11; ++index) {
        const double x = -5.0 + index + random_.between(-0.3, 0.3);
        const double y = random_.between(-0.5, 1.0);
        const double size = random_.between(0.4, 0.9);
        const Placement upright{{x, y, 0.5 * size}, Eigen::Matrix3d::Identity()};
        const std::size_t kind = random_.below(3);
        Solid solid =
            box_at({x, y, 0.5 * size}, {size, 0.8 * size, size}, random_.between(0.0, 1.5));
        if (kind == 1) solid = Cylinder{upright, 0.35 * size, 0.5 * size, 0.0};
        if (kind == 2) {
            solid = Ellipsoid{upright, Eigen::Vector3d(0.45, 0.4, 0.5) * size};
        }
        add("object", std::move(solid), random_material(random_), true);
    }
}

void HazardScenery::add_surroundings() {
    add_floor();
    for (int index = 0; index < 9; ++index) {
        const double azimuth = 2 * std::numbers::pi * (index + random_.uniform()) / 9;
        const double distance = random_.between(1.9, 2.8);
        const double size = random_.between(0.4, 0.9);
        add("object",
            box_at({distance * std::cos(azimuth), distance * std::sin(azimuth), 0.5 * size},
                   {size, 0.7 * size, size}, azimuth),
            random_material(random_), true);
    }
}

void HazardScenery::add_relief(double relief) {
    for (int index = 0; index < 40; ++index) {
        const double depth = relief * random_.between(0.3, 1.0);
        const Eigen::Vector3d centre(random_.between(-3.2, 3.2), kWallY - 0.5 * depth,
                                     random_.between(0.2, 4.0));
        const Eigen::Vector3d size(random_.between(0.3, 0.8), depth, random_.between(0.3, 0.8));
        const Material material = random_material(random_);
        if (relief > 0) add("relief", box_at(centre, size), material, false);
    }
}

}  // namespace lumi
