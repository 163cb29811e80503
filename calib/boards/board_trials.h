#pragma once

#include <vector>

#include "calib/boards/lens_fit.h"
#include "calib/lens/lens_choice.h"

namespace lumi {

/// A fit and what it predicts of photographs kept back, to be compared.
[[nodiscard]] LensTrial trial_of(const BoardViews& board, const LensFit& fit);

/// choose_lens among those that explain what they were fitted to.
/// Of few photographs, how forms differ from one to the next tells little of how surely one is
/// better. What leaves more unexplained where it was fitted than another form does where it was
/// not is too simple all the same.
[[nodiscard]] LensChoice choose_that_explains(std::vector<LensTrial> trials);

}  // namespace lumi
