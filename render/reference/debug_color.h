#pragma once

#include <Eigen/Core>
#include <array>

#include "meshing/surface/inverse_depth_range.h"
#include "render/frame/frame.h"
#include "render/reference/depth_consensus.h"

namespace lumi {

/// What debug pictures tell of a ray.
struct ShownRay {
    std::array<double, 3> weights{};  ///< After occlusion correction.
    std::array<int, 3> view_indices{};
    int face_index = -1;
    bool is_unseen = false;  ///< None of the three sees the point.
    double inverse_depth = 0.0;
    double confidence = 0.0;
    double occluded = 0.0;  ///< The share of the weights that was lost.
};

/// What a debug picture shows at a pixel, 0 to 255 (the paper, figure 9); `scene`: its far and
/// near end.
[[nodiscard]] Eigen::Vector3d debug_color(DebugPicture picture, const ShownRay& ray,
                                          const InverseDepthRange& scene);

/// 0 to 1: two views agree, one has seen it, it is filled, stretched or behind that, a guess.
[[nodiscard]] double confidence_of(const ConsensusDepth& depth);

}  // namespace lumi
