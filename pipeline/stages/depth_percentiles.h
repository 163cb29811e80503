#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace lumi {

/// Every so many pixels of depth maps tell enough for their percentiles.
inline constexpr std::size_t kPercentileStride = 16;

/// The 1st and the 99th percentile of some values.
struct Percentiles {
    float low = 0.0F;
    float high = 0.0F;
};

/// Empty without values.
[[nodiscard]] std::optional<Percentiles> percentiles_of(std::vector<float> values);

}  // namespace lumi
