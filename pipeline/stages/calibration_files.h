#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/boards/board_calibration.h"
#include "calib/boards/board_detection.h"

namespace lumi {

/// Writes a calibration into `folder`: the lens in every format that has words for it (camera.toml
/// is always among them), calibration.svg (coverage and residuals) and calibration.json. Returns
/// the paths. A format of an earlier run that has no words for this lens is removed.
std::vector<std::string> write_calibration(const std::filesystem::path& folder,
                                           const BoardPhotographs& found,
                                           const BoardCalibration& calibration);

/// "f = 700.18  +- 2.51  95 %: 695.18 to 705.18".
[[nodiscard]] std::string parameter_text(const LensParameter& parameter);

/// "0.315 px", or why there is none.
[[nodiscard]] std::string held_out_text(const BoardCalibration& calibration);

}  // namespace lumi
