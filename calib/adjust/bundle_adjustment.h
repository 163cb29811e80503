#pragma once

#include <cstddef>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/work/progress.h"

namespace lumi {

struct BundleAdjustmentOptions {
    double max_reprojection_error_px = 2.0;  ///< Observations beyond this are outliers. > 0.
    int min_track_length = 2;                ///< Points seen by fewer views are dropped. >= 2.
    bool refine_lens = true;
    /// Indices of the parameters that stay as they are, by camera; empty: those of the principal
    /// point, or all unless `refine_lens`.
    std::vector<std::vector<int>> held_lens_parameters;
    double robust_scale_px = 1.0;  ///< Of the Cauchy loss, while outliers may be left. > 0.
    int max_iterations = 100;      ///< Of each of the passes. > 0.
    /// The last pass weighs observations by how far they lie off the others; else all alike.
    bool robust_last_pass = true;
};

/// Refines poses, points and, if asked, the lenses that views share, by least squares over pixels.
///
/// First passes use a robust (Cauchy) loss and remove what lies beyond
/// `max_reprojection_error_px`; the last one has a Cauchy loss of the scale that the observations
/// themselves show (cauchy_scale_px), or is plain least squares (Triggs et al., Bundle adjustment:
/// a modern synthesis, 1999). Distances of features to where they belong have long tails: most lie
/// within a tenth of a pixel or two, and the few per cent beyond a pixel that are no gross errors
/// would have most of the say among squares. The gauge is fixed by the first view's pose and one
/// coordinate of the view farthest from it. Views and cameras keep their indices; a view may end
/// without observations. Runs on one thread, so that the result is the same to the bit.
/// Throws Error: E-ADJUST-FEW (no two views share a point), E-ADJUST-FAILED, E-INTERRUPTED.
void adjust_bundle(Capture& capture, const BundleAdjustmentOptions& options, Progress& progress);

/// The scale of Cauchy's loss for these observations (cauchy_scale.h), from the standard deviation
/// of one coordinate, which the median reprojection error tells. At least 0.05 px.
[[nodiscard]] double cauchy_scale_px(const Capture& capture);

/// What one pass of least squares came to.
struct BundleFit {
    double residual_sum_px2 = 0.0;  ///< Over every observation.
    int residuals = 0;              ///< Two for each observation.
    int iterations = 0;
    bool converged = false;
};

/// One pass of plain least squares over every observation, the gauge fixed as above: nothing is
/// looked for, nothing removed. Throws Error: E-ADJUST-FAILED (also when a point lies behind a
/// camera that saw it), E-INTERRUPTED.
BundleFit fit_bundle(Capture& capture, const BundleAdjustmentOptions& options, Progress& progress);

/// Sets each point's `error_px` to the mean over its track.
void update_point_errors(Capture& capture);

[[nodiscard]] std::size_t count_observations(const Capture& capture);

/// Distance in pixels between where a point is predicted and where it was seen; infinite when the
/// point is not in front of the camera.
[[nodiscard]] double reprojection_error_px(const Capture& capture, const ScenePoint& point,
                                           const Observation& observation);

}  // namespace lumi
