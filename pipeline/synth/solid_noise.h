#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace lumi {

/// Perlin's gradient noise ("Improving noise", 2002) over a hashed lattice of unit cells: smooth,
/// of mean zero, within about [-1, 1], and without a period.
[[nodiscard]] double gradient_noise(const Eigen::Vector3d& point, std::uint32_t seed);

/// In [0, 1): one value for each cell of a pattern.
[[nodiscard]] double cell_value(int u, int v, std::uint32_t seed);

/// How much of a pattern of `frequency` (cycles per world unit) survives when it is averaged over
/// `footprint` (world units): 1 for a fine sampling, 0 when it could only alias.
[[nodiscard]] double surviving_contrast(double frequency, double footprint);

/// How octaves of noise are summed.
struct NoiseOctaves {
    double frequency = 1.0;  ///< Of the first octave, in cycles per world unit; the next is twice.
    int count = 4;
    double persistence = 0.5;  ///< Amplitude of an octave relative to the one before.
};

/// A sum of octaves, of mean zero and within about [-1, 1]; octaves that a sample of the size
/// `footprint` cannot resolve fade out, so that pictures from different places agree.
[[nodiscard]] double fractal_noise(const Eigen::Vector3d& point, double footprint,
                                   const NoiseOctaves& octaves, std::uint32_t seed);

/// 0 below `edge`, 1 above, with a ramp as wide as the sample or `softness`, whichever is more.
[[nodiscard]] double soft_step(double edge, double value, double softness, double footprint);

}  // namespace lumi
