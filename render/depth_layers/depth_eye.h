#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Of an eye's pixels no more are needed for depth than this; fewer would show as steps along
/// silhouettes.
inline constexpr double kLeastTexelsPerPixel = 0.5;

/// Of two samples a pixel, the first lies so far to the left of and above its centre, the second as
/// far to the right and below: on either side of a silhouette that runs near the centre, whichever
/// way it runs, but for one diagonal.
inline constexpr double kSampleOffset_px = 0.25;

/// The eye that depth is drawn for: its texels are as large as the samples of the views' depth
/// maps, as the eye sees them at the scene's centre (median view). Finer ones cost time and tell
/// nothing, but for an eye of several samples a pixel, whose silhouettes are to be smooth: it has
/// a texel for each sample. Eye pixel (x, y) lies in texel (x, y) * texels_per_pixel.
struct DepthEye {
    Eye eye;
    double texels_per_pixel = 1.0;  ///< kLeastTexelsPerPixel to 1.
    /// 2 where depth is sampled as finely as the eye's pixels, so that silhouettes are known to
    /// less than a pixel: depth is drawn at two places in each texel, and where these tell surfaces
    /// apart the pixel is the mean of both. Not where frames fade, nor where close-ups are laid
    /// over, nor where the options do without.
    int samples = 1;

    /// From a pixel's centre, in x and in y. 0 for a single sample.
    [[nodiscard]] double sample_offset_px(int sample) const {
        if (samples == 1) return 0.0;
        return sample == 0 ? -kSampleOffset_px : kSampleOffset_px;
    }
};

/// Whether `perpixel` works out depth, weights and visibility once for each block of two by two
/// pixels (pixel_blocks.h), as the Lumigraph asks for: not where a frame has several samples a
/// pixel, nor where it fades. Texels of depth are blocks then.
[[nodiscard]] bool is_drawn_in_blocks(const Lumigraph& lumigraph, const RenderOptions& options);

[[nodiscard]] DepthEye depth_eye(const Lumigraph& lumigraph, const Eye& eye,
                                 const RenderOptions& options);

}  // namespace lumi
