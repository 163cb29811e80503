#include "render/faces/blend_strips.h"

#include <algorithm>

#include "render/faces/strip_ends.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

std::vector<int> blend_strip_ends(const std::vector<EyeBlend>& blends, int width_px) {
    std::vector<double> shares;
    for (const EyeBlend& blend : blends) shares.push_back(blend.share);
    std::vector<int> ends = strip_ends(shares, width_px / kDepthBlockSide_px);
    for (int& end : ends) end *= kDepthBlockSide_px;
    ends.back() = width_px;
    return ends;
}

const RayWeights& weights_in_strip(const std::vector<EyeBlend>& blends, int width_px,
                                   double pixel_x) {
    const std::vector<int> ends = blend_strip_ends(blends, width_px);
    const auto end = std::upper_bound(ends.begin(), ends.end() - 1, pixel_x);
    return blends[static_cast<std::size_t>(end - ends.begin())].weights;
}

}  // namespace lumi
