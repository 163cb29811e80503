#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {

/// How places in photographs vary on a triangle.
enum class PlaceInterpolation {
    kLinear,      ///< Linearly in space: shaders/blend.glsl.
    kProjective,  ///< As a projective texture: shaders/projective_pass.glsl.
};

/// Triangles blended from three photographs each, in plain code: what the modes that subdivide are
/// tested against. Pixels whose centre no triangle covers, or where no photograph shows anything,
/// stay as they are in `behind`, or black without it, and uncovered; where several do, the last one
/// drawn is seen, or as much of it as its opacity says. Coverage is the sum of the weights, times
/// the opacity; guesses are not covered (kLeastConfidence), but for projective textures.
[[nodiscard]] Frame draw_reference(const BlendTriangles& triangles, const Lumigraph& lumigraph,
                                   const Camera& eye_camera, PlaceInterpolation places,
                                   const ColorImage& behind = {});

}  // namespace lumi
