#pragma once

#include "calib/boards/lens_fit.h"

namespace lumi {

/// Sets BoardView::middle to that of the part that each photograph shows. To be done before points
/// are removed.
void set_middles(BoardViews& board);

/// Sets BoardView::turn_rad, so that a bow is the same in all photographs: the part that each shows
/// is as long the same way. Where a board is as wide as it is high, or seen in part, a photograph
/// counts turned if it is explained clearly better so (three standard deviations) by the bow that
/// the others ask for. Which of its ends is which matters to no bow. `flat` is the fit without a
/// bow.
void count_alike(BoardViews& board, const BoardSolution& flat);

}  // namespace lumi
