#pragma once

#include "calib/boards/lens_fit.h"
#include "calib/capture/posed_photographs.h"

namespace lumi {

/// Views and their solution without what does not belong.
struct CleanedBoard {
    BoardViews board;
    BoardSolution solution;
    std::vector<LeftOut> left_out;
    std::size_t removed_points = 0;
    std::vector<BoardView> whole_views;  ///< Those of the board, with all of their points.
};

/// Fits with a robust loss whose scale shrinks from what the start leaves to one pixel, and removes
/// points beyond five (robust) standard deviations, photographs that lose a third of their points,
/// and photographs four times worse than the median one. Ends with the fit to what is left.
[[nodiscard]] CleanedBoard without_outliers(const BoardViews& board, const BoardSolution& start);

/// Robust standard deviation of one coordinate of the residuals, from their median.
[[nodiscard]] double robust_sigma_px(const BoardViews& board, const BoardSolution& solution);

}  // namespace lumi
