#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "render/reference/depth_raster.h"
#include "render/transfer/past_sight.h"

namespace lumi {

/// The depth that several views' depths at one pixel of the eye come to.
struct ConsensusDepth {
    double inverse_depth = 0.0;
    DepthKind kind = DepthKind::kStretched;
    int best_layer = 0;  ///< First of the layers that agree.
    int support = 0;     ///< How many agree, at most 2; 0: nothing is known.
    /// Whether all that agree see it behind what they stretch over a tear.
    bool is_behind_tears = false;
};

/// The nearest depth that two views agree on, or else the nearest; only the most reliable kind
/// counts, and of fills the farthest, because a fill continues the background. Those that agree are
/// averaged. A surface that one view imagines in front of what others see is thus left out.
[[nodiscard]] ConsensusDepth consensus_of(const std::vector<EyeDepth>& layers,
                                          double agreeing_inverse_depth);

/// Whether the view of a layer looks past the point at this inverse depth, at no more than
/// `nearest_seen` of it (past_sight.h).
using PastOfLayer =
    std::function<Past(std::size_t layer, double inverse_depth, double nearest_seen)>;

/// Settles whether what one view alone has seen before all others is there or imagined
/// (depth_layers/lone_surfaces.h). What is taken away is as if nothing were known.
void settle_lone_surface(std::vector<EyeDepth>& layers, double agreeing_inverse_depth,
                         const PastOfLayer& past);

}  // namespace lumi
