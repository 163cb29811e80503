#pragma once

#include <cstddef>

#include "calib/capture/capture.h"
#include "calib/work/progress.h"

namespace lumi {

/// A capture adjusted twice from one start and over the same observations: for cameras that stood
/// still, and for such that turned evenly while their rows were read out, from top to bottom.
struct ShutterAdjustment {
    Capture steady;
    Capture turning;               ///< Poses at the middle row.
    double steady_cost_px2 = 0.0;  ///< Sum of squared residuals, each truncated at the limit.
    double turning_cost_px2 = 0.0;
    double skew_px = 0.0;          ///< How far pictures turned over the frame: root mean square.
    int parameters = 0;            ///< More than without.
    std::size_t observations = 0;  ///< That were looked at.
};

/// Adjusts poses, points, lenses (focal length and radial distortion, unless `lenses_are_held`) and
/// a turning rate for each view by robust least squares (Hedborg et al., Rolling shutter bundle
/// adjustment, CVPR 2012, for rotation alone, which moves pictures most), over a few hundred points
/// a photograph, those with the longest tracks. A weak prior holds rates that nothing determines.
[[nodiscard]] ShutterAdjustment adjust_for_shutter(const Capture& capture, bool lenses_are_held,
                                                   double limit_px, Progress& progress);

}  // namespace lumi
