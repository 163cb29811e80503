#pragma once

#include "calib/capture/image.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The eye halfway between the two photographs in the middle of their order, as far from both as it
/// can be; at the only photograph, where there is one.
[[nodiscard]] Eye eye_between_photographs(const Lumigraph& lumigraph, int width_px, int height_px);

/// Six pictures of that eye, two a row: without depth, with it; with occlusion correction, too, and
/// the blending weights (one colour a camera; white: none of the three sees the point); inverse
/// depth, the triangles of `adaptive`. Throws Error (E-GL-...).
[[nodiscard]] ColorImage methods_picture(const Lumigraph& lumigraph);

/// At most `max_width_px` wide.
[[nodiscard]] ColorImage fitted_to(const ColorImage& picture, int max_width_px);

}  // namespace lumi
