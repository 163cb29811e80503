#pragma once

#include <functional>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "meshing/depth/depth_model.h"

namespace lumi {

/// How wrong a rung is at what it was not told.
struct RungLoss {
    std::string model;
    double mean_px = 0.0;            ///< Of at most kMaxLossPx a point.
    double standard_error_px = 0.0;  ///< Over blocks of the pictures.
    double p95_px = 0.0;             ///< 95th percentile over the points.
    /// Grey levels by which photographs kept back differ from their prediction (photograph_loss.h),
    /// root mean square; 0 where none could be kept back.
    double photograph = 0.0;
};
constexpr double kMaxLossPx = 4.0;

struct DepthChoice {
    std::string model;
    std::string explanation;       ///< One line: what was chosen, and why.
    std::vector<RungLoss> losses;  ///< Of the rungs that were tried, in order.
};

/// The cheapest rung that is enough: climbs while the next one's held-out error is lower by more
/// than one standard error (Breiman et al. 1984, section 3.4.3, applied rung by rung).
///
/// What is compared is what would be delivered (held_out_trial.h), `masks` (scene_masks) included.
/// A quarter of each sampled view's points is kept back, each quarter in turn for the rungs that
/// know points alone, and one of its neighbours. A rung is enough when it puts 95 % of these points
/// within a pixel of disparity. If none is, the rung counts that predicts the neighbours'
/// photographs best (photograph_loss.h); without two neighbours, the one nearest to the points.
/// Rungs above `highest` are not tried. With fewer than 40 points in every view nothing can be
/// kept back, and `highest` is taken, but not more than the sweep.
[[nodiscard]] DepthChoice choose_depth_model(const DepthScene& scene,
                                             const std::vector<GrayImage>& masks,
                                             const std::string& highest, int threads,
                                             Progress& progress);

}  // namespace lumi
