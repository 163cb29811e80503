#pragma once

#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// A place where what a view has seen ends before something behind it.
struct OutlinePoint {
    float x_px;  ///< Of the photograph, as the next, on the nearer of the two.
    float y_px;
    float inverse_depth;  ///< In the view, one over world units, as the next.
    float step;           ///< What is behind has so much less.
};

/// Points along the outlines in a view's depth map, which are where it tears: `torn` as from
/// torn_squares (surface_tears.h). One for each two by two squares of samples, where the step is
/// largest. A guess has no outline.
[[nodiscard]] std::vector<OutlinePoint> view_outlines(const LumigraphView& view,
                                                      const GrayImage& torn);

}  // namespace lumi
