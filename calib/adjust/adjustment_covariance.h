#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "calib/adjust/bundle_adjustment.h"
#include "calib/capture/capture.h"

namespace lumi {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// How far an adjusted capture may be off, as its observations tell: first order, for noise that
/// is independent between observations.
struct AdjustmentCovariance {
    /// Standard deviation of one observed coordinate: residuals over redundancy; after a robust
    /// last pass that of the Gaussian noise which would leave the estimate as uncertain.
    double noise_px = 0.0;
    /// Of each view's cam_from_world: a small rotation about the camera's axes, (rad) that comes
    /// after it, then its translation (units of the world). Zero for a view without observations.
    std::vector<Matrix6> poses;
    /// Of each camera's parameters; zero rows and columns where they were held.
    std::vector<Eigen::MatrixXd> lenses;
    /// Of each view: how far the picture of the scene's points may move, as the standard deviation
    /// of one coordinate, root mean square over the points seen. Pose and lens count together.
    std::vector<double> jitter_px;
};

/// Propagates the noise of the observations to poses and lenses (Triggs et al., Bundle adjustment:
/// a modern synthesis, 1999, sections 6 and 9). `options` say what of the lenses was refined, and
/// whether the last pass was robust: then the noise is that of an M-estimator (Huber, Robust
/// Statistics, 1981, section 7.6).
///
/// Points are eliminated from the normal equations (Schur complement); what is left, 6 unknowns a
/// view and those of the lenses, is inverted densely: exact, with O(unknowns^3) steps. The gauge is
/// free, and is chosen so that the pictures of the scene move least in all views together (inner
/// constraints, weighted by the pixels that each pose moves): what no choice of the world's frame
/// can remove. Empty when the observations do not determine the unknowns, or for more than
/// `max_unknowns` of poses and lenses (600 views, and lenses that they share): the matrices grow
/// with its square. Throws Error: E-INTERRUPTED.
[[nodiscard]] std::optional<AdjustmentCovariance> adjustment_covariance(
    const Capture& capture, const BundleAdjustmentOptions& options, const Progress& progress,
    int max_unknowns = 4000);

}  // namespace lumi
