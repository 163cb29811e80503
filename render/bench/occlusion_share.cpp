#include "render/bench/occlusion_share.h"

#include <cstddef>
#include <utility>

#include "calib/work/median.h"
#include "render/bench/frame_timing.h"
#include "render/rivals/heigl.h"

namespace lumi {

bool corrects_occlusion(const Lumigraph& lumigraph, const RenderOptions& wanted) {
    const RenderOptions options = possible_options(wanted, lumigraph.has_depth());
    if (options.mode == RenderMode::kHeigl) return corrects_depth_of_heigl(lumigraph, options);
    return options.mode != RenderMode::kLightField;
}

double median_share_saved(const std::vector<double>& with_ms,
                          const std::vector<double>& without_ms) {
    std::vector<double> shares;
    for (std::size_t i = 0; i < with_ms.size(); ++i)
        shares.push_back(1 - without_ms[i] / with_ms[i]);
    return median_of(std::move(shares));
}

double occlusion_share(const Lumigraph& lumigraph, const std::vector<Eye>& path,
                       const RenderOptions& options, Progress& progress) {
    RenderOptions with = options;
    with.correct_occlusion = true;
    RenderOptions without = options;
    without.correct_occlusion = false;
    // The first drawing from a new eye fetches photographs and depth that the next ones find at
    // hand.
    const FrameTimingReport timing =
        time_frames(lumigraph, path, {without, with, without}, progress);
    return median_share_saved(timing.modes[1].frames_cpu_ms, timing.modes[2].frames_cpu_ms);
}

}  // namespace lumi
