#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Of an eye's pixels no more are needed for depth than this; fewer would show as steps along
/// silhouettes.
inline constexpr double kLeastTexelsPerPixel = 0.5;

/// Where depth is sampled as finely as the eye's pixels, so that silhouettes are known to less than
/// a pixel, there are so many texels along each side of one, and it is the mean of what they show.
inline constexpr double kSmoothTexelsPerPixel = 2.0;

/// The eye that depth is drawn for: its texels are as large as the samples of the views' depth
/// maps, as the eye sees them at the scene's centre (median view). Finer ones cost time and tell
/// nothing, but where silhouettes are to be smooth: an eye of several samples a pixel has a texel
/// for each, others have kSmoothTexelsPerPixel; not where frames fade, nor where close-ups are laid
/// over, nor where the options do without. Eye pixel (x, y) lies in texel
/// (x, y) * texels_per_pixel.
struct DepthEye {
    Eye eye;
    double texels_per_pixel = 1.0;  ///< kLeastTexelsPerPixel to 1, or kSmoothTexelsPerPixel.

    [[nodiscard]] bool is_smooth() const { return texels_per_pixel == kSmoothTexelsPerPixel; }
};

/// Whether `perpixel` works out depth, weights and visibility once for each block of two by two
/// pixels (pixel_blocks.h): in frames so fine that blocks are no wider than
/// DrawingChoices::depth_block_px says, at the scene's centre (median view). Not where a frame has
/// several samples a pixel, nor where it fades. Texels of depth are blocks then.
[[nodiscard]] bool is_drawn_in_blocks(const Lumigraph& lumigraph, const Eye& eye,
                                      const RenderOptions& options);

[[nodiscard]] DepthEye depth_eye(const Lumigraph& lumigraph, const Eye& eye,
                                 const RenderOptions& options);

}  // namespace lumi
