#pragma once

#include <vector>

#include "calib/capture/image.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Where photographs count for less than this share of their weights, mixed pixels are all that is
/// known: the picture there is a guess, but for the photograph of a camera that is so near the eye
/// that nothing in the scene moves by more than kMostParallax_px between them. As in
/// shaders/per_pixel.glsl.
inline constexpr double kLeastCounting = 0.25;
inline constexpr double kMostParallax_px = 1.0;

/// What a photograph counts per pixel even where its opacity is 0, beyond its border: nothing
/// beside any other, but it is shown where it alone sees a point. As in shaders/per_pixel.glsl.
inline constexpr double kLeastOpacity = 1.0 / 1024;

/// How much each pixel of a photograph counts where photographs are blended, 1 to 255: the alpha
/// of its texture.
///
/// A photograph fades in from its border over a few pixels, so that none begins with a jump. Pixels
/// along a tear of the depth map hold the colours of two surfaces and belong to neither: they count
/// little, so that they are seen only where no other photograph knows better, and those next to
/// them, into which they are interpolated, count less. `disparity_px` turns inverse depth into
/// pixels (view_geometry.h). Without depth only the border counts.
[[nodiscard]] GrayImage photograph_opacity(const LumigraphView& view, double disparity_px);

/// The same for all views of a Lumigraph.
[[nodiscard]] std::vector<GrayImage> photograph_opacities(const Lumigraph& lumigraph);

}  // namespace lumi
