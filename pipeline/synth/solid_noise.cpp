#include "pipeline/synth/solid_noise.h"

#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

/// The hash of a lattice point is made axis by axis, so that neighbours share their first stages.
std::uint32_t stirred(std::uint32_t hash, std::int32_t coordinate) {
    hash += 0x9E3779B9u * static_cast<std::uint32_t>(coordinate);
    hash = (hash ^ (hash >> 16)) * 0x85EBCA6Bu;
    return hash ^ (hash >> 13);
}

/// The directions to the edges of a cube, four of them twice: a table, because branches on a hash
/// cannot be foreseen.
constexpr double kGradients[16][3] = {
    {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
    {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}, {1, 1, 0}, {0, -1, 1}, {-1, 1, 0}, {0, -1, -1},
};

double along_gradient(std::uint32_t hash, double x, double y, double z) {
    const double* gradient = kGradients[hash & 15u];
    return gradient[0] * x + gradient[1] * y + gradient[2] * z;
}

double fade(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

double mix(double a, double b, double t) { return a + t * (b - a); }

/// std::floor is a call where the processor's instruction for it cannot be taken for granted.
std::int32_t floor_of(double value) {
    const auto truncated = static_cast<std::int32_t>(value);
    return truncated - (value < truncated ? 1 : 0);
}

}  // namespace

double gradient_noise(const Eigen::Vector3d& point, std::uint32_t seed) {
    const std::int32_t ix = floor_of(point.x());
    const std::int32_t iy = floor_of(point.y());
    const std::int32_t iz = floor_of(point.z());
    const double x = point.x() - ix;
    const double y = point.y() - iy;
    const double z = point.z() - iz;
    const double u = fade(x);
    const double v = fade(y);
    const auto along_z = [&](std::uint32_t column, double dx, double dy) {
        return mix(along_gradient(stirred(column, iz), x - dx, y - dy, z),
                   along_gradient(stirred(column, iz + 1), x - dx, y - dy, z - 1.0), fade(z));
    };
    const auto along_y = [&](std::uint32_t plane, double dx) {
        return mix(along_z(stirred(plane, iy), dx, 0.0), along_z(stirred(plane, iy + 1), dx, 1.0),
                   v);
    };
    return mix(along_y(stirred(seed, ix), 0.0), along_y(stirred(seed, ix + 1), 1.0), u);
}

double cell_value(int u, int v, std::uint32_t seed) {
    return stirred(stirred(stirred(seed, u), v), 0) * 0x1p-32;
}

double surviving_contrast(double frequency, double footprint) {
    // Close to exp(-2 cycles^2), and cheaper: it falls to a tenth at one cycle a sample.
    constexpr double kCutOff = 1.8;
    const double cycles = frequency * footprint / kCutOff;
    const double rest = std::max(1.0 - cycles * cycles, 0.0);
    return rest * rest * rest * rest * rest * rest;
}

double fractal_noise(const Eigen::Vector3d& point, double footprint, const NoiseOctaves& octaves,
                     std::uint32_t seed) {
    double sum = 0.0;
    double total = 0.0;
    double amplitude = 1.0;
    double frequency = octaves.frequency;
    for (int octave = 0; octave < octaves.count; ++octave) {
        const double contrast = surviving_contrast(frequency, footprint);
        if (contrast > 0.0) {
            // The shift keeps the lattices, on which every octave is zero, from coinciding.
            const Eigen::Vector3d shift = Eigen::Vector3d::Constant(0.37 * octave);
            sum += amplitude * contrast *
                   gradient_noise(frequency * point + shift,
                                  seed + static_cast<std::uint32_t>(octave));
        }
        total += amplitude;
        amplitude *= octaves.persistence;
        frequency *= 2.0;
    }
    return sum / total;
}

double soft_step(double edge, double value, double softness, double footprint) {
    const double width = std::max(softness, footprint);
    const double t = std::clamp((value - edge) / width + 0.5, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace lumi
