#pragma once

#include "calib/boards/board_views.h"
#include "calib/capture/posed_photographs.h"

namespace lumi {

/// Removes photographs that show the board where an earlier one does, to a quarter of a pixel:
/// files that are there twice, saved again, or taken from a tripod without moving the board. They
/// tell nothing new, yet counted twice they would make the lens look more certain than it is, and
/// one would predict the other. Returns what was removed (E-BOARD-COPY).
[[nodiscard]] std::vector<LeftOut> remove_copies(BoardViews& board);

}  // namespace lumi
