#pragma once

#include <vector>

#include "calib/capture/image.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// How much each pixel of a photograph counts where photographs are blended, 1 to 255: the alpha
/// of its texture.
///
/// A photograph fades in from its border over a few pixels, so that none begins with a jump. Pixels
/// along a tear of the depth map hold the colours of two surfaces and belong to neither: they count
/// little, so that they are seen only where no other photograph knows better. `disparity_px` turns
/// inverse depth into pixels (view_geometry.h). Without depth only the border counts.
[[nodiscard]] GrayImage photograph_opacity(const LumigraphView& view, double disparity_px);

/// The same for all views of a Lumigraph.
[[nodiscard]] std::vector<GrayImage> photograph_opacities(const Lumigraph& lumigraph);

}  // namespace lumi
