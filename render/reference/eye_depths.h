#pragma once

#include "render/frame/frame.h"
#include "render/reference/depth_consensus.h"

namespace lumi {

/// What the views' depths come to at each pixel of the eye, with the views that were asked
/// (depth_view_choice.h). Support 0 where nothing is known.
struct EyeDepths {
    Image<ConsensusDepth> depths;
    std::vector<int> view_indices;
};

/// Needs depth. In plain code.
[[nodiscard]] EyeDepths eye_depths(const Lumigraph& lumigraph, const Eye& eye, double tolerance_px);

/// The same as a depth map: seen where one of these views sees it, a fill elsewhere; where none
/// knows anything the scene plane, as a fill.
[[nodiscard]] DepthMap depth_map_at(const Lumigraph& lumigraph, const Eye& eye,
                                    double tolerance_px);

/// The point at a pixel; `inverse_depth` > 0.
[[nodiscard]] Eigen::Vector3d point_in_world(const Eye& eye, int x, int y, double inverse_depth);

}  // namespace lumi
