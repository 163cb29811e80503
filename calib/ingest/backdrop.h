#pragma once

#include <optional>

#include "calib/ingest/image_rectangle.h"
#include "calib/ingest/standing_pixels.h"

namespace lumi {

/// Levels of luma.
struct LevelRange {
    double darkest = 0;
    double brightest = 0;

    /// But for what compression makes of a level.
    [[nodiscard]] bool contains(double level) const {
        return level >= darkest - kStillSpread && level <= brightest + kStillSpread;
    }
};

/// Of the backdrop of a camera that stood still, as before a turntable: where most pixels along the
/// border of the picture do, their levels, without the darkest and the brightest twentieth. Empty
/// where they do not.
[[nodiscard]] std::optional<LevelRange> backdrop_levels(const StandingPixels& standing,
                                                        const ImageRectangle& picture);

}  // namespace lumi
