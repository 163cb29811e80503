#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/reference/eye_depths.h"

namespace lumi {

struct ViewDependentTextureOptions {
    int polygon_px = 8;  ///< Side of the square patches of surface that choose their views as one.
    /// As UnstructuredLumigraphOptions::occlusion_epsilon.
    double occlusion_epsilon = 0.02;
};

/// View-dependent texture mapping after Debevec, Taylor, Malik (1996) and Debevec, Yu, Borshukov
/// (1998) in plain code: each polygon is textured from the three views that see its middle from the
/// directions nearest to the eye's, weighted by one over the angle, as in 1996. The view map of
/// 1998, which holds the best views of evenly sampled directions ahead, is left out: that the
/// choice jumps as the eye moves is of the choice made here. Polygons choose on their own, so the
/// picture is not continuous across their edges. What none of the three sees is a polygon of its
/// own, as the paper cuts polygons where views are hidden; whether a view sees the point is asked
/// at each pixel, which is more than the paper has. The scene has no polygons here: patches of the
/// eye's picture, each of one surface, stand for them, and the pixel next to the mean of theirs for
/// the middle. `known` is the geometry, which the paper is given.
[[nodiscard]] Frame draw_view_dependent_texture(const Lumigraph& lumigraph, const Eye& eye,
                                                const EyeDepths& known,
                                                const ViewDependentTextureOptions& options = {});

}  // namespace lumi
