#pragma once

#include "calib/capture/image.h"
#include "calib/ingest/bars.h"
#include "calib/ingest/standing_pixels.h"

namespace lumi {

/// What was laid over all photographs of a capture: a date, a logo, a watermark, bars of one colour
/// beside the picture, a lens hood in its corners.
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
/// Bars are looked for first (bars.h). What lies over the picture that they leave is edges, of luma
/// or in one colour, that point the same way in nearly every photograph (what median gradients tell
/// of watermarks, Dekel et al., On the effectiveness of visible watermarks, CVPR 2017), areas whose
/// pixels stand still although all around them changes, black corners (black_corners.h), and what
/// such edges enclose if it changes by less than half of what the picture does; without pieces of
/// less than 24 pixels, and with a margin of four.
///
/// Nothing lies over it where most of its border stands still (backdrop.h: of what turns before
/// that, parts stand still, too), where a fifth of it would be covered (the camera did not move, or
/// the background did with it), less than 0.25 % (chance), or among many edges that nearly stand
/// still: those are far away along a straight rail, or what the camera turned about. Of fewer than
/// kFewestForOverlay photographs nothing is told.
[[nodiscard]] Overlay overlay_of(const StandingPixels& standing, int min_side_px = 1);

}  // namespace lumi
