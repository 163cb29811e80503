#pragma once

#include <opencv2/core.hpp>

#include "calib/ingest/image_rectangle.h"
#include "calib/ingest/standing_pixels.h"

namespace lumi {

/// 255 where a lens hood, a filter or a lens made for smaller pictures hides a corner of the
/// picture in all photographs, 0 elsewhere; in the raster of `picture`.
///
/// Pixels that are black and stand still, joined to a corner, and what lies around them until
/// brightness recovers: where the median level of all pixels at one distance from them rises by no
/// more than a twentieth over three pixels. It has to, within a sixth of the shorter side, and
/// most of the pixels before have to become brighter the same way in most photographs, as a dark
/// scene or what turns before a black backdrop does not.
[[nodiscard]] cv::Mat black_corners(const StandingPixels& standing, const ImageRectangle& picture);

}  // namespace lumi
