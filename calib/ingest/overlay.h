#pragma once

#include "calib/capture/image.h"
#include "calib/ingest/standing_pixels.h"

namespace lumi {

/// Pixels from `left` and `top` on.
struct ImageRectangle {
    int left = 0;
    int top = 0;
    int width_px = 0;
    int height_px = 0;
    friend bool operator==(const ImageRectangle&, const ImageRectangle&) = default;
};

/// What was laid over all photographs of a capture: a date, a logo, a watermark, bars of one colour
/// beside the picture.
struct Overlay {
    ImageRectangle picture;  ///< What bars leave; the whole raster where there are none.
    /// 0 where something lies over the picture, 255 elsewhere; in the raster of `picture`. Empty:
    /// nothing does.
    GrayImage mask;
    double share = 0.0;  ///< Of `picture` that is covered.
};

/// Fewer photographs than this may show the same at a pixel by chance.
inline constexpr int kFewestForOverlay = 8;

/// Tells the overlay from how the photographs' pixels changed.
///
/// Bars: rows and columns along the border nearly all of whose pixels stand still, and that end
/// within three pixels, in all photographs at the same; two more are taken with them. What is left
/// has a quarter of each side or more, and `min_side_px`. Other overlays: edges that point the same
/// way in nearly every photograph (what median gradients tell of watermarks, Dekel et al., On the
/// effectiveness of visible watermarks, CVPR 2017), areas whose pixels stand still although all
/// around them changes, and what such edges enclose if it changes by less than half of what the
/// picture does; without pieces of less than 24 pixels, and with a margin of four.
///
/// But for bars there is none where a fifth of the picture would be covered (the camera did not
/// move, or the background did with it), less than 0.25 % (chance), or among many edges that nearly
/// stand still: those are far away along a straight rail, or what the camera turned about.
[[nodiscard]] Overlay overlay_of(const StandingPixels& standing, int min_side_px = 1);

}  // namespace lumi
