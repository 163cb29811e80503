#pragma once

#include <vector>

#include "calib/work/progress.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Whether the wanted mode, as it is drawn of this Lumigraph, corrects occlusion at all: only then
/// does it draw anything else with RenderOptions::correct_occlusion off.
[[nodiscard]] bool corrects_occlusion(const Lumigraph& lumigraph, const RenderOptions& wanted);

/// The median over frames of 1 - without / with; negative where frames take longer without. Entry i
/// of both lists is the same frame.
[[nodiscard]] double median_share_saved(const std::vector<double>& with_ms,
                                        const std::vector<double>& without_ms);

/// How much of a frame's CPU time the paper's occlusion correction (section 4) takes
/// (median_share_saved). Each frame is drawn with it and without in turn, since frames differ from
/// each other by more than that, and once before, to fetch what both need. Throws Error (E-GL-...).
[[nodiscard]] double occlusion_share(const Lumigraph& lumigraph, const std::vector<Eye>& path,
                                     const RenderOptions& options, Progress& progress);

}  // namespace lumi
