#pragma once

#include <CLI/CLI.hpp>

namespace lumi {

/// For an option: a finite number above 0. (What CLI::PositiveNumber takes for one is also NaN.)
[[nodiscard]] CLI::Validator positive_number();

/// For an option: a number from `least` to `most`. (CLI::Range lets NaN pass.)
[[nodiscard]] CLI::Validator number_from_to(double least, double most);

}  // namespace lumi
