#pragma once

#include <vector>

#include "calib/capture/inverse_depth_warp.h"
#include "meshing/exposure/color_match.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// What a view knows, and shows.
struct ShownDepth {
    const DepthMap& known;  ///< Confidence 0 where it is unknown.
    const ColorImage& picture;
};

/// The surfaces that two views both know, to `tolerance` of the first one's inverse depth, in the
/// colours of both: every `step`th pixel of every `step`th row of the other.
[[nodiscard]] std::vector<SharedColor> shared_colors(const ShownDepth& own, const ShownDepth& other,
                                                     const InverseDepthWarp& own_from_other,
                                                     float tolerance, int step);

}  // namespace lumi
