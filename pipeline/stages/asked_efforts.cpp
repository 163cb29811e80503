#include "pipeline/stages/asked_efforts.h"

#include <string>

#include "calib/work/error.h"
#include "pipeline/stages/chosen_views.h"

namespace lumi {
namespace {

/// As photographs want it; where nothing can be drawn, as by default.
template <typename Effort>
Effort asked(const std::function<Effort(const Lumigraph&, const Capture&)>& sufficient,
             const PackSources& sources, const Lumigraph& lumigraph, Progress& progress) {
    if (!sufficient) return {};
    try {
        return sufficient(lumigraph, capture_of(lumigraph, sources.photographs));
    } catch (const Error& error) {
        if (!error.code().starts_with("E-GL-")) throw;
        progress.note(std::string("nothing can be drawn here to see how much is enough: ") +
                      error.what());
        return {};
    }
}

/// What is done, and what photographs say to it.
template <typename Effort>
void note(const Effort& effort, Progress& progress) {
    if (const std::string text = text_of(effort); !text.empty()) progress.note("pack: " + text);
}

}  // namespace

DepthMeshEffort depth_mesh_effort(const PackSources& sources, const Lumigraph& lumigraph,
                                  Progress& progress) {
    if (sources.drawing.noisy_depth_error_px != 0)
        return {.noisy_error_px = sources.drawing.noisy_depth_error_px};
    const DepthMeshEffort effort =
        asked(sources.sufficient_depth_mesh_effort, sources, lumigraph, progress);
    note(effort, progress);
    return effort;
}

OcclusionEffort occlusion_effort(const PackSources& sources, const Lumigraph& lumigraph,
                                 Progress& progress) {
    if (sources.drawing.occlusion_tolerance_px != 0)
        return {.tolerance_px = sources.drawing.occlusion_tolerance_px};
    const OcclusionEffort effort =
        asked(sources.sufficient_occlusion_effort, sources, lumigraph, progress);
    note(effort, progress);
    return effort;
}

DepthEffort depth_effort(const PackSources& sources, const Lumigraph& lumigraph,
                         Progress& progress) {
    const DrawingOptions& wanted = sources.drawing;
    DepthEffort effort;
    if (wanted.depth_views == 0 || wanted.depth_block_px == 0 || !wanted.fill_holes ||
        !wanted.check_guesses)
        effort = asked(sources.sufficient_depth_effort, sources, lumigraph, progress);
    if (wanted.depth_views != 0) effort.views = wanted.depth_views;
    if (wanted.depth_block_px != 0) effort.block_px = wanted.depth_block_px;
    effort.fills_holes = wanted.fill_holes.value_or(effort.fills_holes);
    effort.checks_guesses = wanted.check_guesses.value_or(effort.checks_guesses);
    note(effort, progress);
    return effort;
}

TriangleEffort triangle_effort(const PackSources& sources, const Lumigraph& lumigraph,
                               Progress& progress) {
    const DrawingOptions& wanted = sources.drawing;
    TriangleEffort effort;
    if (wanted.triangle_error_px == 0 || !wanted.draw_thin)
        effort = asked(sources.sufficient_triangle_effort, sources, lumigraph, progress);
    if (wanted.triangle_error_px != 0) {
        effort.error_px = wanted.triangle_error_px;
        effort.loses_db = effort.triangles = 0;  // Were those of another.
    }
    effort.draws_thin = wanted.draw_thin.value_or(effort.draws_thin);
    note(effort, progress);
    return effort;
}

}  // namespace lumi
