#pragma once

#include "meshing/surface/depth_map.h"

namespace lumi {

/// A map that others were carried into pixel by pixel, without lone pixels and small gaps: each
/// pixel has the median of the known ones of the 3 x 3 around it if these are four or more, and is
/// not known otherwise. Confidence kKnown or kUnseen; nothing is known along the border.
[[nodiscard]] DepthMap with_gaps_closed(const DepthMap& map);

}  // namespace lumi
