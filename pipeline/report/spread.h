#pragma once

#include <cstddef>
#include <vector>

namespace lumi {

/// At most `count` indices below `size`, spread evenly, the first included.
[[nodiscard]] inline std::vector<std::size_t> spread(std::size_t size, std::size_t count) {
    std::vector<std::size_t> chosen;
    const std::size_t shown = size < count ? size : count;
    for (std::size_t i = 0; i < shown; ++i) chosen.push_back(i * size / shown);
    return chosen;
}

}  // namespace lumi
