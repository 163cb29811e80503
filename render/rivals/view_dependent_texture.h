#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

struct ViewDependentTextureOptions {
    int polygon_px = 8;  ///< Side of the square patches of surface that choose their views as one.
    double occlusion_epsilon = 0.01;
    double tolerance_px = kAgreeingDisparity_px;  ///< Of the depth at the eye (eye_depths.h).
};

/// View-dependent texture mapping (Debevec, Yu, Borshukov 1998) in plain code: each polygon is
/// textured from the three views that see its middle from the directions nearest to the eye's,
/// weighted by one over the angle. Polygons choose on their own, so the picture is not continuous
/// across their edges. The scene has no polygons here: patches of the eye's picture, each of one
/// surface, stand for them.
[[nodiscard]] Frame draw_view_dependent_texture(const Lumigraph& lumigraph, const Eye& eye,
                                                const ViewDependentTextureOptions& options = {});

}  // namespace lumi
