#pragma once

#include <string>
#include <string_view>

namespace lumi {

/// What reports and manifests can hold; a file's name may be anything.
[[nodiscard]] bool is_utf8(std::string_view text);

/// The text with every control character (C0, DEL, and C1 in UTF-8) and every byte that is not
/// UTF-8 written as \xNN, so that a name from a file cannot steer a terminal or a window's title.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace lumi
