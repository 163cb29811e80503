#pragma once

#include <CLI/App.hpp>
#include <optional>

#include "calib/work/error.h"

namespace lumi {

/// What to say of a command line, as far as `app` has read it, that names a command or an option
/// that there is none of: E-USAGE with the nearest that there is; empty where something else is
/// wrong with the line.
[[nodiscard]] std::optional<Error> error_of_unknown_word(const CLI::App& app);

}  // namespace lumi
