#pragma once

#include <string_view>

namespace lumi {

/// The text of a number without a plus sign before it, which std::from_chars refuses and the
/// programs that write such files do not.
[[nodiscard]] inline std::string_view without_plus(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    return text;
}

}  // namespace lumi
