#pragma once

#include <string>

namespace lumi {

/// The words of a text with hyphens between, as files and options are named: "paper2001, triangles
/// >= 6 px" becomes paper2001-triangles-6-px. Of other than ASCII letters, digits and dots nothing
/// stays.
[[nodiscard]] std::string hyphenated(const std::string& text);

}  // namespace lumi
