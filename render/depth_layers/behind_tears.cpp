#include "render/depth_layers/behind_tears.h"

#include <algorithm>
#include <cstddef>

#include "render/depth_layers/depth_kind_ranges.h"

namespace lumi {

void lay_before_tears(std::span<float> texels, std::span<const float> stretched,
                      float agreeing_depth) {
    constexpr auto kSeenEnds = static_cast<float>(kDepthKindStep);
    constexpr auto kStretchedBegins = static_cast<float>(2 * kDepthKindStep);
    // Without branches, so that it is done for several texels at once.
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const bool is_behind = stretched[i] - kStretchedBegins + agreeing_depth < texels[i];
        const float seen = told_behind_tear(texels[i], is_behind);
        texels[i] = texels[i] < kSeenEnds ? seen : std::min(texels[i], stretched[i]);
    }
}

}  // namespace lumi
