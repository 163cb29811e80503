#pragma once

#include <string>

namespace lumi {

/// The version that COLMAP says it is, such as "COLMAP 3.8 -- ..."; it is part of the key of what
/// COLMAP made. "PROGRAM not found" when it cannot be run: whoever needs it will say so.
[[nodiscard]] std::string colmap_version(const std::string& program);

}  // namespace lumi
