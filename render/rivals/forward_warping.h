#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

struct ForwardWarpingOptions {
    int views = 3;  ///< Those that see the scene most as the eye does.
    /// Half the side of the square that a sample covers; where the eye sees it larger than the view
    /// does, as many times this, so that a photograph that is coarser than the frame has no holes;
    /// at most eight times, as an eye that touches a surface sees its samples without bounds.
    double splat_px = 0.75;
    double same_share = 0.01;  ///< Depths that differ by less are of one surface and are blended.
};

/// Forward warping of depth images (Schirmacher, Heidrich, Seidel 2000) in plain code: every pixel
/// of the nearest views goes to where the eye sees it; the nearest surface stays, what several
/// views say about it is blended. Holes stay open.
[[nodiscard]] Frame draw_forward_warping(const Lumigraph& lumigraph, const Eye& eye,
                                         const ForwardWarpingOptions& options = {});

}  // namespace lumi
