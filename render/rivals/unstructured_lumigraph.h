#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/reference/eye_depths.h"

namespace lumi {

struct UnstructuredLumigraphOptions {
    /// A view sees another surface when its inverse depth differs by more than this share
    /// (SameSurface): a fixed epsilon, as published implementations have.
    double occlusion_epsilon = 0.02;
};

/// Unstructured lumigraph rendering (Buehler et al., SIGGRAPH 2001) in plain code: for each pixel
/// the four views with the least penalty of angle, resolution and field of view that see the point,
/// of all views. The paper weighs at the vertices of a triangulated picture and draws that with
/// textures; here it is done at every pixel, which is finer and takes longer. `known` is the
/// geometry, which the paper is given.
[[nodiscard]] Frame draw_unstructured_lumigraph(const Lumigraph& lumigraph, const Eye& eye,
                                                const EyeDepths& known,
                                                const UnstructuredLumigraphOptions& options = {});

}  // namespace lumi
