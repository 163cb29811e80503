#pragma once

#include <string>

namespace lumi {

/// A number with a fixed count of decimals, "." whatever the locale.
[[nodiscard]] std::string number_text(double value, int decimals);

}  // namespace lumi
