#pragma once

#include <vector>

#include "render/reference/depth_raster.h"

namespace lumi {

/// The depth that several views' depths at one pixel of the eye come to.
struct ConsensusDepth {
    double inverse_depth = 0.0;
    DepthKind kind = DepthKind::kStretched;
    int best_layer = 0;  ///< First of the layers that agree.
    int support = 0;     ///< How many agree, at most 2; 0: nothing is known.
};

/// The nearest depth that two views agree on, or else the nearest; only the most reliable kind
/// counts, and of fills the farthest, because a fill continues the background. Those that agree are
/// averaged. A surface that one view imagines in front of what others see is thus left out.
[[nodiscard]] ConsensusDepth consensus_of(const std::vector<EyeDepth>& layers,
                                          double agreeing_inverse_depth);

}  // namespace lumi
