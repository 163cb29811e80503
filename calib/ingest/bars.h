#pragma once

#include "calib/ingest/image_rectangle.h"
#include "calib/ingest/standing_pixels.h"

namespace lumi {

/// What bars of one colour leave of photographs, told from how their pixels changed; the whole
/// raster where there are none.
///
/// Bars are rows and columns along the border nearly all of whose pixels stand still, most of them
/// with one level along the line (but for a caption amid the bar), and that end within three
/// pixels, in all photographs at the same; two more are taken with them. Unless they leave a
/// quarter of each side, and `min_side_px`, they are none. Nor are they where rows and columns
/// would be cut off and what is left lies off the middle, as what turns before a plain backdrop
/// does: unless a frame is all black or all white, and has a sharp edge along all of its four
/// sides. Nor where what they leave has a backdrop of their level (backdrop.h): then they are more
/// of it. Few photographs tell nothing (kFewestForOverlay).
[[nodiscard]] ImageRectangle picture_between_bars(const StandingPixels& standing, int min_side_px);

}  // namespace lumi
