#pragma once

#include "calib/capture/image.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Four pictures of one eye in the middle of the path through the views, two by two: without depth,
/// with it, the blending weights (one colour a camera), inverse depth. Throws Error (E-GL-...).
[[nodiscard]] ColorImage methods_picture(const Lumigraph& lumigraph);

/// At most `max_width_px` wide.
[[nodiscard]] ColorImage fitted_to(const ColorImage& picture, int max_width_px);

}  // namespace lumi
