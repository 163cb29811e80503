#include "pipeline/stages/depth_range.h"

#include <algorithm>

namespace lumi {
namespace {

/// Sorted inverse depths above zero of every 16th pixel.
std::vector<float> inverse_depths(const std::vector<LumigraphView>& views, bool only_confident) {
    constexpr std::size_t kStride = 16;
    std::vector<float> values;
    for (const LumigraphView& view : views) {
        const std::vector<float>& pixels = view.depth.inverse_depth.pixels();
        const std::vector<std::uint8_t>& confidence = view.depth.confidence.pixels();
        for (std::size_t i = 0; i < pixels.size(); i += kStride) {
            if (pixels[i] > 0.0F && (!only_confident || was_seen(confidence[i]))) {
                values.push_back(pixels[i]);
            }
        }
    }
    std::sort(values.begin(), values.end());
    return values;
}

}  // namespace

DepthRange depth_range_of(const std::vector<LumigraphView>& views) {
    std::vector<float> values = inverse_depths(views, true);
    if (values.empty()) values = inverse_depths(views, false);
    if (values.empty()) return {};
    const std::size_t margin = values.size() / 100;
    return {1.0 / static_cast<double>(values[values.size() - 1 - margin]),
            1.0 / static_cast<double>(values[margin])};
}

}  // namespace lumi
