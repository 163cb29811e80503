#pragma once

#include "calib/work/progress.h"
#include "pipeline/stages/pack_stage.h"

namespace lumi {

/// How a package is to be drawn: as the drawing options say, where they do; else as photographs
/// want it, which is noted; where nothing can be drawn here to ask them, as it is by default.
[[nodiscard]] DepthMeshEffort depth_mesh_effort(const PackSources& sources,
                                                const Lumigraph& lumigraph, Progress& progress);
[[nodiscard]] OcclusionEffort occlusion_effort(const PackSources& sources,
                                               const Lumigraph& lumigraph, Progress& progress);
[[nodiscard]] DepthEffort depth_effort(const PackSources& sources, const Lumigraph& lumigraph,
                                       Progress& progress);
[[nodiscard]] TriangleEffort triangle_effort(const PackSources& sources, const Lumigraph& lumigraph,
                                             Progress& progress);

}  // namespace lumi
