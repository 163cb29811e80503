#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/boards/board_projection.h"
#include "calib/lens/lens_choice.h"
#include "calib/lens/lens_form.h"

namespace lumi {

/// A lens, the size of the squares, and where the board stood in each photograph.
struct BoardSolution {
    LensForm form;
    Camera lens;
    double size_per_pitch = 0.0;
    std::vector<BoardPose> cam_from_board;  ///< One a view.
};

struct LensFitOptions {
    double robust_scale_px = 0.0;  ///< Of a Cauchy loss; 0: plain least squares.
    int max_iterations = 60;
};

/// What speaks for a fit.
struct LensFit {
    BoardSolution solution;
    double residual_sum_px2 = 0.0;  ///< Sum of squares, without the loss.
    int residuals = 0;              ///< Two a point.
    int iterations = 0;
    bool is_usable = false;  ///< The solver ended at a finite minimum.
};

/// Least squares over pixels for lens, size (unless known) and poses together, with Ceres; the
/// poses are eliminated first. One thread, so that the result is the same to the bit.
[[nodiscard]] LensFit fit_lens(const BoardViews& board, const BoardSolution& start,
                               const LensFitOptions& options = {});

/// Normal equations of one photograph with its pose eliminated, for what all photographs share:
/// the free parameters of the lens, and the size where it is estimated (last).
struct ReducedView {
    Eigen::MatrixXd information;  ///< Of the shared parameters, pixels as unit of error.
    Eigen::VectorXd gradient;
    double residual_sum_px2 = 0.0;
    int residuals = 0;
};
[[nodiscard]] std::vector<ReducedView> reduced_views(const BoardViews& board,
                                                     const BoardSolution& solution);

/// Held-out error of each photograph: the lens estimated without it, its pose solved again. From
/// the reduced normal equations at the minimum, hence exact to first order in what one photograph
/// changes (Allen's PRESS, by blocks; Cook and Weisberg, Residuals and Influence in Regression,
/// 1982, section 2.2). Empty when the others do not determine the lens.
[[nodiscard]] std::vector<HeldOutFold> held_out_photographs(const std::vector<ReducedView>& views);

/// How certain the shared parameters are.
struct LensCertainty {
    Eigen::MatrixXd covariance;   ///< Of all parameters of the lens; zero rows where held.
    double point_sigma_px = 0.0;  ///< Of one coordinate, from the residuals.
    /// How much more photographs disagree about the lens than independent errors of their points
    /// would let them (squared; at least 1): errors that a photograph's points share, such as a
    /// bent board, motion or rolling shutter. The covariance contains it.
    double disagreement = 1.0;
    int degrees_of_freedom = 0;
};

/// From the information of all photographs, scaled by the jackknife over photographs pooled over
/// the parameters (Efron, The Jackknife, the Bootstrap and Other Resampling Plans, 1982). An
/// empty covariance when the photographs do not determine the lens.
[[nodiscard]] LensCertainty lens_certainty(const std::vector<ReducedView>& views,
                                           const LensForm& form);

}  // namespace lumi
