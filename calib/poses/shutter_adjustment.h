#pragma once

#include "calib/capture/capture.h"
#include "calib/work/progress.h"

namespace lumi {

/// A capture adjusted for cameras that turned evenly while their rows were read out, from the top
/// to the bottom.
struct ShutterAdjustment {
    Capture capture;        ///< Poses at the middle row; points; the lenses as they were.
    double cost_px2 = 0.0;  ///< Truncated at the limit, over all observations given.
    double skew_px = 0.0;   ///< How far the picture turned over the frame: root mean square.
    int parameters = 0;     ///< More than an adjustment without.
};

/// Adjusts poses, points and a turning rate for each view by robust least squares (Hedborg et al.,
/// Rolling shutter bundle adjustment, CVPR 2012, for rotation alone, which moves pictures most).
/// A weak prior holds rates that nothing determines. Lenses are held.
[[nodiscard]] ShutterAdjustment adjust_for_shutter(const Capture& capture, double limit_px,
                                                   Progress& progress);

}  // namespace lumi
