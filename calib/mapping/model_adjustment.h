#pragma once

#include "calib/mapping/growing_model.h"
#include "calib/work/progress.h"

namespace lumi {

struct ModelAdjustmentOptions {
    bool refine_lenses = true;
    double robust_scale_px = 1.0;  ///< Of the Cauchy loss. > 0.
    int max_iterations = 25;       ///< > 0.
    /// Points are left out while every photograph that sees them has this many others. > 0.
    int points_a_photograph = 250;
};

/// Refines the poses of all placed photographs and, if asked, their lenses, by least squares over
/// the pixels of the points that the longest tracks give; those points move too. On one thread, so
/// that the result is the same to the bit. Throws Error (E-INTERRUPTED).
void adjust_model(GrowingModel& model, const ModelAdjustmentOptions& options, Progress& progress);

/// The same for one photograph and the few that share most points with it; everything else holds
/// still.
void adjust_around(GrowingModel& model, int photograph, const ModelAdjustmentOptions& options,
                   Progress& progress);

}  // namespace lumi
