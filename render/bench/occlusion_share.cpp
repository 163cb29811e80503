#include "render/bench/occlusion_share.h"

#include <cstddef>
#include <utility>

#include "calib/work/median.h"
#include "render/bench/frame_timing.h"

namespace lumi {

bool corrects_occlusion(RenderMode mode) {
    return mode == RenderMode::kPaper2001 || mode == RenderMode::kAdaptive ||
           mode == RenderMode::kPerPixel;
}

double occlusion_share(const Lumigraph& lumigraph, const std::vector<Eye>& path,
                       const RenderOptions& options, Progress& progress) {
    RenderOptions with = options;
    with.correct_occlusion = true;
    RenderOptions without = options;
    without.correct_occlusion = false;
    const FrameTimingReport timing = time_frames(lumigraph, path, {with, without}, progress);
    std::vector<double> shares;
    for (std::size_t i = 0; i < path.size(); ++i)
        shares.push_back(1 - timing.modes[1].frames_cpu_ms[i] / timing.modes[0].frames_cpu_ms[i]);
    return median_of(std::move(shares));
}

}  // namespace lumi
