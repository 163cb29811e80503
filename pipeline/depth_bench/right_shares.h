#pragma once

#include <optional>
#include <vector>

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Shares of pixels whose depth is within one pixel of the true disparity, in the neighbour that
/// sees them move fastest. 0 where there are no such pixels.
struct RightShares {
    double of_confident = 0.0;  ///< Of the pixels that the found maps claim to know.
    /// Of the pixels with texture (window_match.h) that some neighbour sees, claimed or not.
    double of_visible = 0.0;
};

/// `truth` and `found`: a map of each view of the scene; truth counts where its confidence is not
/// 0.
[[nodiscard]] RightShares right_shares(const DepthScene& scene, const std::vector<DepthMap>& truth,
                                       const std::vector<DepthMap>& found);

/// By how much the scene's points are nearer than the truth at their pixels, as the median ratio of
/// inverse depths: 1 where both are in one unit of length. Empty where too few points tell.
[[nodiscard]] std::optional<double> points_by_truth(const DepthScene& scene,
                                                    const std::vector<DepthMap>& truth);

}  // namespace lumi
