#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace lumi {

/// A well mixed 64-bit word (the finaliser of SplitMix64, Steele et al. 2014).
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t value) {
    value += 0x9E3779B97F4A7C15ull;
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9ull;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBull;
    return value ^ (value >> 31);
}

/// A source of random numbers that depends on its seed alone: the same on every platform, and
/// cheap enough to be started anew for each pixel.
class HashedRandom {
 public:
    explicit HashedRandom(std::uint64_t seed) : state_(mixed(seed)) {}
    /// A stream of its own for each `stream` of one seed.
    HashedRandom(std::uint64_t seed, std::uint64_t stream)
        : state_(mixed(mixed(seed) ^ (stream * 0xD1342543DE82EF95ull))) {}

    [[nodiscard]] std::uint64_t word() { return state_ = mixed(state_); }
    /// In [0, 1).
    [[nodiscard]] double uniform() { return static_cast<double>(word() >> 11) * 0x1p-53; }
    /// In [low, high).
    [[nodiscard]] double between(double low, double high) { return low + (high - low) * uniform(); }
    /// In [-1, 1).
    [[nodiscard]] double symmetric() { return 2.0 * uniform() - 1.0; }
    /// Of mean 0 and variance 1 (Box and Muller 1958).
    [[nodiscard]] double gaussian() {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return radius * std::cos(2.0 * std::numbers::pi * uniform());
    }
    /// In [0, count).
    [[nodiscard]] std::size_t below(std::size_t count) {
        return static_cast<std::size_t>(uniform() * static_cast<double>(count));
    }

 private:
    std::uint64_t state_;
};

}  // namespace lumi
