#include "pipeline/stages/depth_range.h"

#include <utility>

#include "pipeline/stages/depth_percentiles.h"

namespace lumi {
namespace {

/// Inverse depths above zero.
std::vector<float> inverse_depths(const std::vector<LumigraphView>& views, bool only_confident) {
    std::vector<float> values;
    for (const LumigraphView& view : views) {
        const std::vector<float>& pixels = view.depth.inverse_depth.pixels();
        const std::vector<std::uint8_t>& confidence = view.depth.confidence.pixels();
        for (std::size_t i = 0; i < pixels.size(); i += kPercentileStride) {
            if (pixels[i] > 0.0F && (!only_confident || was_seen(confidence[i]))) {
                values.push_back(pixels[i]);
            }
        }
    }
    return values;
}

}  // namespace

DepthRange depth_range_of(const std::vector<LumigraphView>& views) {
    std::vector<float> values = inverse_depths(views, true);
    if (values.empty()) values = inverse_depths(views, false);
    const std::optional<Percentiles> inverse = percentiles_of(std::move(values));
    if (!inverse) return {};
    return {1.0 / static_cast<double>(inverse->high), 1.0 / static_cast<double>(inverse->low)};
}

}  // namespace lumi
