#pragma once

#include <exception>
#include <optional>

#include "calib/work/error.h"

namespace lumi {

/// What ended some work, as an Error: one that is an Error already as it is, E-FILE-SYSTEM (kind
/// kResources when the disk is full) and E-MEMORY for what the standard library throws, the latter
/// also for OpenCV. None for everything else, which is a bug.
[[nodiscard]] std::optional<Error> error_of_exception(const std::exception& exception);

/// Of several pieces of work, one of which ended so: whether the others end, too. They do with an
/// interruption and a full disk, which meets the next one as well; memory that one is too large for
/// may suffice for the next.
[[nodiscard]] bool ends_all_work(const Error& error);

}  // namespace lumi
