#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace lumi {

/// Normally distributed numbers by name: the same on any machine, whatever was asked before.
class SeededNormal {
 public:
    explicit SeededNormal(std::uint64_t seed) : seed_(seed) {}

    /// Uniform in (0, 1).
    [[nodiscard]] double uniform(std::uint64_t a, std::uint64_t b) const;
    /// Mean 0, standard deviation 1 (Box and Muller, 1958).
    [[nodiscard]] double value(std::uint64_t a, std::uint64_t b) const;
    [[nodiscard]] Eigen::Vector3d vector(std::uint64_t a) const;

 private:
    std::uint64_t seed_;
};

}  // namespace lumi
