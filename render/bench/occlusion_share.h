#pragma once

#include <vector>

#include "calib/work/progress.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Whether the mode corrects occlusion at all, as it is drawn of this Lumigraph, so that it can be
/// drawn without.
[[nodiscard]] bool corrects_occlusion(const Lumigraph& lumigraph, const RenderOptions& wanted);

/// The median over frames of the share that each takes less without something than with it; less
/// than 0 where it takes more. Both are as many, of the same frames.
[[nodiscard]] double median_share_saved(const std::vector<double>& with_ms,
                                        const std::vector<double>& without_ms);

/// How much of a frame's CPU time the paper's occlusion correction (section 4) takes
/// (median_share_saved). Each frame is drawn with it and without in turn, as the two differ by less
/// than frames do, and once before that. Throws Error (E-GL-...).
[[nodiscard]] double occlusion_share(const Lumigraph& lumigraph, const std::vector<Eye>& path,
                                     const RenderOptions& options, Progress& progress);

}  // namespace lumi
