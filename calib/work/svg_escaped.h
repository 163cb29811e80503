#pragma once

#include <string>

namespace lumi {

/// Text as it may stand in an element of an SVG picture: without the control characters that XML
/// does not allow.
[[nodiscard]] std::string svg_escaped(const std::string& text);

}  // namespace lumi
