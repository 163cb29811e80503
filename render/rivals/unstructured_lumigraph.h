#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

struct UnstructuredLumigraphOptions {
    /// A view sees another surface when its depth differs by more than this share: the fixed
    /// epsilon of published implementations.
    double occlusion_epsilon = 0.01;
    double tolerance_px = kAgreeingDisparity_px;  ///< Of the depth at the eye (eye_depths.h).
};

/// Unstructured lumigraph rendering (Buehler et al., SIGGRAPH 2001) in plain code: for each pixel
/// the four views with the least penalty of angle and resolution that see the point, of all views.
[[nodiscard]] Frame draw_unstructured_lumigraph(const Lumigraph& lumigraph, const Eye& eye,
                                                const UnstructuredLumigraphOptions& options = {});

}  // namespace lumi
