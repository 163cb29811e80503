#pragma once

#include <string>

namespace lumi {

/// Versions of lumi and of what it is built from and drives, one a line.
[[nodiscard]] std::string version_text();

}  // namespace lumi
