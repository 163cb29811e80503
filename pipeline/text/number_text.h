#pragma once

#include <string>

namespace lumi {

/// A number with a fixed count of decimals, "." whatever the locale.
[[nodiscard]] std::string number_text(double value, int decimals);

/// The shortest text that reads back to the same number, "." whatever the locale: "0.1", "100".
[[nodiscard]] std::string shortest_number_text(double value);

}  // namespace lumi
