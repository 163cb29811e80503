#include "render/faces/blend_strips.h"

#include <algorithm>

#include "render/faces/strip_ends.h"

namespace lumi {

std::vector<int> blend_strip_ends(const std::vector<EyeBlend>& blends, int width_px) {
    std::vector<double> shares;
    for (const EyeBlend& blend : blends) shares.push_back(blend.share);
    return strip_ends(shares, width_px);
}

std::size_t strip_at(const std::vector<int>& strip_ends, double pixel_x) {
    const auto end = std::upper_bound(strip_ends.begin(), strip_ends.end() - 1, pixel_x);
    return static_cast<std::size_t>(end - strip_ends.begin());
}

}  // namespace lumi
