#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/boards/board_projection.h"
#include "calib/lens/lens_form.h"

namespace lumi {

/// A lens, the size of the squares, where the board stood in each photograph, and how it is bent.
struct BoardSolution {
    LensForm form;
    Camera lens;
    double size_per_pitch = 0.0;
    std::vector<BoardPose> cam_from_board;  ///< One a view.
    BoardBow bow{};
    bool is_bent = false;  ///< Whether the bow is estimated; else it is zero.
};
/// Of the bow: 0 or 3.
[[nodiscard]] int free_parameters_of_board(const BoardSolution& solution);

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

/// Least squares over pixels for lens, size (unless known), bow (if any) and poses together, with
/// Ceres; the poses are eliminated first. One thread, so that the result is the same to the bit.
[[nodiscard]] LensFit fit_lens(const BoardViews& board, const BoardSolution& start,
                               const LensFitOptions& options = {});

/// Places of the free parameters among those of the lens.
[[nodiscard]] std::vector<int> free_parameter_indices(const LensForm& form);

/// Normal equations of one photograph with its pose eliminated, for what all photographs share:
/// the free parameters of the lens, the size where it is estimated, and the bow of a bent board.
struct ReducedView {
    Eigen::MatrixXd information;  ///< Of the shared parameters, pixels as unit of error.
    Eigen::VectorXd gradient;
    double residual_sum_px2 = 0.0;
    int residuals = 0;
};
[[nodiscard]] std::vector<ReducedView> reduced_views(const BoardViews& board,
                                                     const BoardSolution& solution);

}  // namespace lumi
