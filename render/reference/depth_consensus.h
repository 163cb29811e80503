#pragma once

#include <cstddef>
#include <functional>
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

/// Whether the view of a layer sees something behind the point at this inverse depth, where the
/// point lies in it.
using LooksPast = std::function<bool(std::size_t layer, double inverse_depth)>;

/// What one view alone has seen before what two others agree on is there all the same where none of
/// these looks past it: something else hides it from them (depth_layers/lone_surfaces.h). What they
/// agree on is taken away, as if nothing were known.
void keep_lone_surface(std::vector<EyeDepth>& layers, double agreeing_inverse_depth,
                       const LooksPast& looks_past);

}  // namespace lumi
