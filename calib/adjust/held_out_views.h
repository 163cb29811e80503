#pragma once

#include <vector>

#include "calib/adjust/bundle_adjustment.h"
#include "calib/capture/capture.h"
#include "calib/lens/lens_choice.h"

namespace lumi {

struct HeldOutViewsOptions {
    int folds = 5;            ///< Groups of views, each left out of one fit. >= 2.
    double max_error_px = 4;  ///< An observation counts for no more than this. > 0.
};

/// How well poses, points and lens predict photographs that took no part in them: one entry for
/// each view of camera `camera_index`, in their order.
///
/// Whole views are held out and not single observations, because a lens is what all views share:
/// errors that neighbouring pixels of a photograph have in common (features that lean to one side,
/// a rolling shutter) are learnt from the neighbours by a model with parameters to spare, but are
/// of no help in another photograph. Every group of views is left out of one fit; each of its views
/// is then placed by the lens and the points that the other views agree on (resection), and its
/// distances to them are the prediction error. The six unknowns of that pose are the same in
/// every model. A view that sees nothing of what two others agree on has an unusable entry.
/// `fitted` is where the fits start; its observations are taken as they are. Throws Error as
/// fit_bundle does.
[[nodiscard]] std::vector<HeldOutFold> predict_held_out_views(
    const Capture& fitted, int camera_index, const BundleAdjustmentOptions& adjustment,
    const HeldOutViewsOptions& options, int threads, Progress& progress);

/// The same sums, of the fit's own residuals: what a prediction cannot fall below.
[[nodiscard]] std::vector<HeldOutFold> fitted_views(const Capture& fitted, int camera_index,
                                                    const HeldOutViewsOptions& options);

}  // namespace lumi
