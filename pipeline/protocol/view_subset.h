#pragma once

#include <vector>

#include "meshing/cameras/camera_mesh_builder.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The views at `kept` (rising indices) alone, with their depth as it is and a camera mesh over
/// them.
[[nodiscard]] Lumigraph only_these_views(const Lumigraph& lumigraph, const std::vector<int>& kept,
                                         const CameraMeshOptions& mesh_options);

}  // namespace lumi
