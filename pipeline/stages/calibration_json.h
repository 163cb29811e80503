#pragma once

#include <nlohmann/json_fwd.hpp>

#include "calib/boards/board_calibration.h"
#include "calib/boards/board_detection.h"

namespace lumi {

/// A calibration and what speaks for it, for machines. Errors are distances; those under `models`
/// are of one coordinate, as everywhere that lenses are compared.
[[nodiscard]] nlohmann::ordered_json calibration_json(const BoardPhotographs& found,
                                                      const BoardCalibration& calibration);

}  // namespace lumi
