#pragma once

#include <string>

#include "calib/boards/board_calibration.h"

namespace lumi {

/// An SVG drawing of where the board was seen and what is left unexplained: the picture with every
/// point and its residual, enlarged; all residuals about zero with the circles that hold 39 and 86
/// per cent of normal errors; and the residual along the radius against the distance from the
/// principal point, where a lens model that is too simple shows as a curve.
[[nodiscard]] std::string calibration_svg(const BoardCalibration& calibration);

}  // namespace lumi
