#pragma once

#include <string>
#include <vector>

namespace lumi {

/// A row of comma-separated values with its line end; cells with commas, quotation marks or line
/// ends are quoted (RFC 4180).
[[nodiscard]] std::string csv_row(const std::vector<std::string>& cells);

}  // namespace lumi
