#pragma once

#include <string>
#include <vector>

#include "calib/boards/board_outliers.h"
#include "calib/lens/lens_choice.h"
#include "calib/work/progress.h"

namespace lumi {

/// Lens models fitted to photographs of a board, and which of them they support.
struct FittedModels {
    LensChoice choice;
    std::vector<BoardSolution> solutions;  ///< In the order of the models that were asked for.
};

/// Every model, each from the simpler one before it. The choice is that of choose_lens among
/// models that do not leave clearly more unexplained than another leaves in photographs that took
/// no part. Throws Error: E-INTERRUPTED.
[[nodiscard]] FittedModels fit_models(const CleanedBoard& cleaned,
                                      const std::vector<LensModel>& models, Progress& progress);

[[nodiscard]] const BoardSolution& chosen_solution(const FittedModels& fitted);

/// Without the parameters that measurement cannot tell from nothing, as far as photographs that
/// took no part are predicted as well without them. Nothing puts a principal point in the middle
/// of the picture by right: holding it there is a step of its own. What the certainty of a
/// fisheye's focal length would rest on is not held. `dropped` gains what went.
[[nodiscard]] BoardSolution supported(const BoardViews& board, const BoardSolution& solution,
                                      std::vector<std::string>& dropped);

}  // namespace lumi
