#pragma once

#include <nlohmann/json_fwd.hpp>

#include "calib/boards/board_calibration.h"
#include "calib/boards/board_detection.h"

namespace lumi {

/// A calibration and what speaks for it, for machines.
[[nodiscard]] nlohmann::ordered_json calibration_json(const BoardPhotographs& found,
                                                      const BoardCalibration& calibration);

}  // namespace lumi
