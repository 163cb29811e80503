#pragma once

#include "calib/boards/board_calibration.h"

namespace lumi {

/// Fills in what each photograph contributed, the residuals, how much of the picture was covered,
/// and the warnings that follow.
void add_evidence(const BoardViews& board, const BoardSolution& solution,
                  const std::vector<HeldOutFold>& held_out, BoardCalibration& result);

/// True when different directions go to different pixels as far out as points were seen: the
/// distortion grows with the angle all the way.
[[nodiscard]] bool is_one_to_one(const BoardViews& board, const BoardSolution& solution);

}  // namespace lumi
