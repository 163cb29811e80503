#pragma once

#include <Eigen/Core>

#include "meshing/surface/camera_mesh.h"
#include "render/frame/frame.h"
#include "render/reference/depth_consensus.h"

namespace lumi {

/// What a debug picture shows at a pixel, 0 to 255 (the paper, figure 9). `ray` has the weights
/// after occlusion correction, `unseen`: none of the three sees the point; `occluded`: the share of
/// the weights that was lost; `inverse_depth_range`: the scene's far and near end.
[[nodiscard]] Eigen::Vector3d debug_color(DebugPicture picture, const RayWeights& ray, bool unseen,
                                          const ConsensusDepth& depth, double occluded,
                                          const Eigen::Vector2d& inverse_depth_range);

}  // namespace lumi
