#include "pipeline/stress/seeded_normal.h"

#include <cmath>
#include <numbers>

#include "pipeline/synth/hashed_random.h"

namespace lumi {

double SeededNormal::uniform(std::uint64_t a, std::uint64_t b) const {
    const std::uint64_t bits = mixed(mixed(mixed(seed_) ^ a) ^ b) >> 11U;  // 53 bits.
    return (static_cast<double>(bits) + 0.5) / 9007199254740992.0;
}

double SeededNormal::value(std::uint64_t a, std::uint64_t b) const {
    const double radius = std::sqrt(-2.0 * std::log(uniform(a, 2 * b)));
    return radius * std::cos(2.0 * std::numbers::pi * uniform(a, 2 * b + 1));
}

Eigen::Vector3d SeededNormal::vector(std::uint64_t a) const {
    return {value(a, 0), value(a, 1), value(a, 2)};
}

}  // namespace lumi
