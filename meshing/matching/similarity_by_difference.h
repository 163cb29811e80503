#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace lumi {

/// Similarity of two values by their difference in 8-bit levels: 1 for none, 1 / e at `scale`.
[[nodiscard]] inline std::array<float, 256> similarity_by_difference(double scale) {
    std::array<float, 256> similarity{};
    for (std::size_t difference = 0; difference < similarity.size(); ++difference)
        similarity[difference] =
            static_cast<float>(std::exp(-static_cast<double>(difference) / scale));
    return similarity;
}

}  // namespace lumi
