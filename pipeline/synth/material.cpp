#include "pipeline/synth/material.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/synth/solid_noise.h"

namespace lumi {
namespace {

LinearColor mixed_color(const LinearColor& a, const LinearColor& b, double t) {
    return a + static_cast<float>(std::clamp(t, 0.0, 1.0)) * (b - a);
}

double fraction(double value) { return value - std::floor(value); }

LinearColor stone(const Material& material, const Eigen::Vector3d& point, double footprint) {
    const double frequency = 1.0 / material.feature_size;
    const double clouds = fractal_noise(point, footprint, {frequency, 3, 0.6}, material.seed);
    const double speckle_frequency = 6.0 * frequency;
    const double speckles =
        fractal_noise(point, footprint, {speckle_frequency, 2, 0.5}, material.seed + 50);
    const LinearColor ground =
        mixed_color(material.colors[0], material.colors[1], 0.5 + 1.3 * clouds);
    return mixed_color(ground, material.colors[2],
                       soft_step(0.33, speckles, 0.12, footprint * speckle_frequency));
}

/// Bright lines where a warped wave crosses zero.
double veins(const Eigen::Vector3d& point, const Eigen::Vector3d& across, double frequency,
             double footprint, std::uint32_t seed) {
    const double warp = fractal_noise(point, footprint, {0.8 * frequency, 4, 0.55}, seed);
    const double wave =
        std::abs(std::sin(std::numbers::pi * (frequency * across.dot(point) + 2.4 * warp)));
    const double near_crossing = 1.0 - wave;
    const double thin =
        near_crossing * near_crossing * near_crossing * near_crossing * near_crossing;
    constexpr double kMean = 0.1;
    return kMean + surviving_contrast(3.0 * frequency, footprint) * (thin - kMean);
}

LinearColor marble(const Material& material, const Eigen::Vector3d& point, double footprint) {
    const double frequency = 1.0 / material.feature_size;
    const double clouds =
        fractal_noise(point, footprint, {0.7 * frequency, 3, 0.55}, material.seed);
    const double coarse =
        veins(point, Eigen::Vector3d(0.6, 0.5, 0.62), frequency, footprint, material.seed + 100);
    const double fine = veins(point, Eigen::Vector3d(-0.7, 0.4, 0.6), 2.7 * frequency, footprint,
                              material.seed + 200);
    const LinearColor ground =
        mixed_color(material.colors[0], material.colors[2], 0.25 + 0.9 * clouds);
    return mixed_color(mixed_color(ground, material.colors[1], 0.45 * fine), material.colors[1],
                       0.9 * coarse);
}

/// Wood that grew along the x axis, its heart `heart` away from the world's axis.
LinearColor wood(const Material& material, const Eigen::Vector3d& point,
                 const Eigen::Vector3d& heart, double ring_frequency, double footprint) {
    const Eigen::Vector3d stretched(0.12 * point.x(), point.y(), point.z());
    const Eigen::Vector3d from_heart = stretched + heart;
    const double warp =
        fractal_noise(from_heart, footprint, {0.25 * ring_frequency, 3, 0.5}, material.seed + 10);
    const double rings = ring_frequency * std::hypot(from_heart.y(), from_heart.z()) + 1.6 * warp;
    const double late_wood = std::pow(0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * rings), 2.0);
    constexpr double kMean = 0.375;
    const double ring_contrast = surviving_contrast(2.0 * ring_frequency, footprint);
    const double grain =
        fractal_noise(from_heart, footprint, {4.0 * ring_frequency, 3, 0.6}, material.seed + 20);
    const LinearColor ground = mixed_color(material.colors[0], material.colors[1],
                                           kMean + ring_contrast * (late_wood - kMean));
    return mixed_color(ground, material.colors[2], 0.2 + 0.8 * grain);
}

/// A place on a wall or floor laid in running bond.
struct Course {
    int column = 0;
    int row = 0;
    double to_edge = 0.0;  ///< Distance to the nearest joint, world units.
};

Course course_at(double u, double v, double length, double height, double shift_per_row) {
    Course course;
    course.row = static_cast<int>(std::floor(v / height));
    const double along = u / length + shift_per_row * course.row;
    course.column = static_cast<int>(std::floor(along));
    const double to_end = length * (0.5 - std::abs(fraction(along) - 0.5));
    const double to_side = height * (0.5 - std::abs(fraction(v / height) - 0.5));
    course.to_edge = std::min(to_end, to_side);
    return course;
}

LinearColor planks(const Material& material, const Eigen::Vector3d& point, double footprint) {
    const double width = material.feature_size;
    const Course board = course_at(point.x(), point.y(), 9.0 * width, width, 0.37);
    const double tone = cell_value(board.column, board.row, material.seed);
    const Eigen::Vector3d heart(31.0 * tone, (3.0 * tone - 1.3) * width,
                                width * (1.0 + 2.0 * cell_value(board.row, board.column, 9)));
    const LinearColor color = wood(material, point, heart, 6.0 / width, footprint);
    const double joint = soft_step(0.012 * width, board.to_edge, 0.02 * width, footprint);
    return color * static_cast<float>((0.7 + 0.5 * tone) * (0.25 + 0.75 * joint));
}

LinearColor bricks(const Material& material, const Eigen::Vector3d& point,
                   const Eigen::Vector3d& normal, double footprint) {
    const double length = material.feature_size;
    const double height = 0.34 * length;
    const Eigen::Vector3d facing = normal.cwiseAbs();
    const double u = facing.x() > facing.y() ? point.y() : point.x();
    const double v = facing.z() > std::max(facing.x(), facing.y()) ? point.y() : point.z();
    const double wobble =
        0.03 * length * fractal_noise(point, footprint, {2.0 / length, 2, 0.5}, material.seed + 30);
    const Course brick = course_at(u + wobble, v + wobble, length, height, 0.5);
    const double tone = cell_value(brick.column, brick.row, material.seed);
    const double clouds =
        fractal_noise(point, footprint, {3.0 / length, 3, 0.6}, material.seed + 40);
    const LinearColor body =
        mixed_color(material.colors[0], material.colors[1], tone + 0.8 * clouds) *
        static_cast<float>(0.8 + 0.4 * cell_value(brick.row, brick.column, material.seed + 1));
    return mixed_color(material.colors[2], body,
                       soft_step(0.022 * length, brick.to_edge, 0.02 * length, footprint));
}

LinearColor glaze(const Material& material, const Eigen::Vector3d& point, double footprint) {
    const double frequency = 1.0 / material.feature_size;
    const double brush = 0.35 * fractal_noise(point, footprint, {frequency, 4, 0.5}, material.seed);
    const double height = frequency * point.z() + brush;
    const int band = static_cast<int>(std::floor(height));
    const double share = 0.15 + 0.5 * cell_value(band, 0, material.seed + 1);
    const double in_band = fraction(height);
    const double ramp = footprint * frequency;
    const double painted =
        soft_step(0.0, in_band, 0.06, ramp) * (1.0 - soft_step(share, in_band, 0.06, ramp));
    const LinearColor& paint =
        cell_value(band, 1, material.seed + 2) < 0.6 ? material.colors[1] : material.colors[2];
    return mixed_color(material.colors[0], paint,
                       surviving_contrast(frequency, footprint) * painted);
}

LinearColor pattern_at(const Material& material, const Eigen::Vector3d& point,
                       const Eigen::Vector3d& normal, double footprint) {
    switch (material.pattern) {
        case Pattern::kStone:
            return stone(material, point, footprint);
        case Pattern::kMarble:
            return marble(material, point, footprint);
        case Pattern::kWood:
            return wood(material, point, Eigen::Vector3d(0.0, 0.31, 0.17),
                        1.0 / material.feature_size, footprint);
        case Pattern::kPlanks:
            return planks(material, point, footprint);
        case Pattern::kBricks:
            return bricks(material, point, normal, footprint);
        case Pattern::kGlaze:
            return glaze(material, point, footprint);
    }
    return material.colors[0];
}

/// The turn about the z axis that brings what faces along `normal` into the first sector.
Eigen::AngleAxisd into_first_sector(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                    int sectors) {
    const bool faces_up = std::abs(normal.z()) > 0.9;
    const Eigen::Vector3d& heading = faces_up ? point : normal;
    const double sector_rad = 2.0 * std::numbers::pi / sectors;
    const double turns = std::round(std::atan2(heading.y(), heading.x()) / sector_rad);
    return {-turns * sector_rad, Eigen::Vector3d::UnitZ()};
}

}  // namespace

LinearColor linear_from_srgb(const Eigen::Vector3f& srgb) {
    return srgb.unaryExpr([](float value) {
        return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
    });
}

Eigen::Vector3f srgb_from_linear(const LinearColor& linear) {
    return linear.unaryExpr([](float value) {
        const float clamped = std::clamp(value, 0.0f, 1.0f);
        return clamped <= 0.0031308f ? 12.92f * clamped
                                     : 1.055f * std::pow(clamped, 1.0f / 2.4f) - 0.055f;
    });
}

LinearColor albedo_at(const Material& material, const Eigen::Vector3d& point_in_world,
                      const Eigen::Vector3d& normal, double footprint) {
    if (material.copies_around > 1) {
        const Eigen::AngleAxisd turn =
            into_first_sector(point_in_world, normal, material.copies_around);
        Material plain = material;
        plain.copies_around = 1;
        return albedo_at(plain, turn * point_in_world, turn * normal, footprint);
    }
    const LinearColor color = pattern_at(material, point_in_world, normal, footprint);
    const double detail = fractal_noise(point_in_world, footprint,
                                        {1.0 / material.detail_size, 4, 0.6}, material.seed + 7);
    const double factor = std::max(1.0 + 2.0 * material.detail_contrast * detail, 0.05);
    return (color * static_cast<float>(factor)).cwiseMax(0.0f).cwiseMin(1.0f);
}

}  // namespace lumi
