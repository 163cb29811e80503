#pragma once

#include <exception>
#include <optional>

#include "calib/work/error.h"

namespace lumi {

/// What ended some work, as an Error: one that is an Error already as it is, E-FILE-SYSTEM (kind
/// kResources when the disk is full) and E-MEMORY for what the standard library throws, the latter
/// also for OpenCV. None for everything else, which is a bug.
[[nodiscard]] std::optional<Error> error_of_exception(const std::exception& exception);

}  // namespace lumi
