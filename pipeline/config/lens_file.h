#pragma once

#include <optional>
#include <string>

#include "calib/capture/camera.h"

namespace lumi {

/// The lens as canonical text that keeps every bit; "" when there is none.
[[nodiscard]] std::string lens_parameters_text(const std::optional<Camera>& lens);

}  // namespace lumi
