#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "calib/boards/lens_fit.h"
#include "calib/lens/lens_choice.h"

namespace lumi {

/// Held-out error of each photograph: the lens estimated without it, its pose solved again. From
/// the reduced normal equations at the minimum, hence exact to first order in what one photograph
/// changes (Allen's PRESS, by blocks; Cook and Weisberg, Residuals and Influence in Regression,
/// 1982, section 2.2). Empty when the others do not determine the lens.
[[nodiscard]] std::vector<HeldOutFold> held_out_photographs(const std::vector<ReducedView>& views);

/// Where normal equations have their minimum, and the equations there.
struct LinearStep {
    Eigen::VectorXd change;  ///< Of the shared parameters.
    std::vector<ReducedView> views;
};
/// Empty when the photographs do not determine it.
[[nodiscard]] std::optional<LinearStep> step_to_minimum(const std::vector<ReducedView>& views);
/// Sum of squared residuals of one photograph after a change of the shared parameters, the best
/// pose for it included.
[[nodiscard]] double residual_sum_after_px2(const ReducedView& view, const Eigen::VectorXd& change);

/// How certain the shared parameters are.
struct LensCertainty {
    Eigen::MatrixXd covariance;   ///< Of all parameters of the lens; zero rows where held.
    Eigen::MatrixXd of_board;     ///< Of what else photographs share, in ReducedView's order.
    double point_sigma_px = 0.0;  ///< Of one coordinate, from the residuals.
    /// How much more photographs disagree about the lens than independent errors of their points
    /// would let them (squared; at least 1): errors that a photograph's points share, such as
    /// motion or rolling shutter. The covariance contains it.
    double disagreement = 1.0;
    int degrees_of_freedom = 0;
};

/// From the information of all photographs, scaled by the jackknife over photographs (Efron, The
/// Jackknife, the Bootstrap and Other Resampling Plans, 1982): pooled over the parameters, and
/// along directions in which photographs disagree more than that, beyond chance, by that
/// direction's own. An empty covariance when the photographs do not determine the lens.
[[nodiscard]] LensCertainty lens_certainty(const std::vector<ReducedView>& views,
                                           const LensForm& form);

}  // namespace lumi
