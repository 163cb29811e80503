#pragma once

#include <vector>

#include "render/depth_mesh/collapsing_mesh.h"
#include "render/depth_mesh/mesh_decimation.h"

namespace lumi {

/// Draws vertices into neighbours as long as the options allow (mesh_decimation.h). Triangles that
/// are gone are no longer alive; `points` keeps its order.
void collapse_half_edges(const std::vector<DisparityPoint>& points,
                         std::vector<CollapsingTriangle>& triangles,
                         const DecimationOptions& options);

}  // namespace lumi
