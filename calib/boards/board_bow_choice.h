#pragma once

#include <vector>

#include "calib/boards/board_lens_choice.h"

namespace lumi {

/// Fits every lens model with a bow of the board as well, where photographs ask for one, and
/// replaces what was chosen if they do. They ask when the best pair of lens and bow predicts
/// photographs kept back better than the flat board's lens by more than two standard errors (a pair
/// that has no more parameters than this lens, which then had taken up the bow, need only predict
/// as well), and when the bow as a whole is no nearer to nothing than a single parameter two
/// standard deviations off. That nobody could see the difference is no reason against: all
/// photographs share a bow, and so no interval contains what it does to the lens. Asked first of
/// the equations at each flat fit, so that a flat board costs two linearisations a model, and keeps
/// its lens to the last digit. Throws Error: E-INTERRUPTED.
void allow_for_bow(CleanedBoard& cleaned, FittedModels& fitted,
                   const std::vector<LensModel>& models, Progress& progress);

/// The solution of a bent board once more, from all points of the photographs that were kept: a bow
/// makes many of them look wrong to a fit without it, and hides others.
[[nodiscard]] BoardSolution cleaned_anew(CleanedBoard& cleaned, const BoardSolution& bent);

}  // namespace lumi
