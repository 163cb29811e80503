#pragma once

#include <string>

#include "calib/boards/board_calibration.h"

namespace lumi {

/// Fills in what each photograph contributed, the residuals, how much of the picture was covered,
/// and the warnings that follow.
void add_evidence(const BoardViews& board, const BoardSolution& solution,
                  const std::vector<HeldOutFold>& held_out, BoardCalibration& result);

/// lens_fault as far out as points were seen.
[[nodiscard]] std::string fault_within(const BoardViews& board, const Camera& lens);

}  // namespace lumi
