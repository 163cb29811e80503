#include "pipeline/stages/depth_percentiles.h"

#include <algorithm>

namespace lumi {

std::optional<Percentiles> percentiles_of(std::vector<float> values) {
    if (values.empty()) return std::nullopt;
    std::sort(values.begin(), values.end());
    const std::size_t margin = values.size() / 100;
    return Percentiles{values[margin], values[values.size() - 1 - margin]};
}

}  // namespace lumi
