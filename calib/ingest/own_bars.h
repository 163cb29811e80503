#pragma once

#include "calib/capture/image.h"
#include "calib/ingest/image_rectangle.h"

namespace lumi {

/// What black or white bars at two opposite sides leave of one photograph, told from it alone; the
/// whole raster where there are none.
///
/// A bar is rows, or else columns, along the border nearly all of whose pixels are black, or white,
/// and that end within three pixels along most of their length; two more are taken with them. The
/// two have to be equally wide (up to a hundredth of the side), and to leave more than half.
[[nodiscard]] ImageRectangle picture_between_own_bars(const ColorImage& photograph);

}  // namespace lumi
