#pragma once

#include <string>

namespace lumi {

/// Text in a column of plain text, filled up with spaces on its left or its right.
[[nodiscard]] inline std::string padded_left(const std::string& text, std::size_t width) {
    return std::string(width > text.size() ? width - text.size() : 0, ' ') + text;
}
[[nodiscard]] inline std::string padded_right(const std::string& text, std::size_t width) {
    return text + std::string(width > text.size() ? width - text.size() : 0, ' ');
}
/// The same, with a space at least on its right.
[[nodiscard]] inline std::string column(const std::string& text, std::size_t width) {
    return padded_right(text, width > text.size() ? width : text.size() + 1);
}

}  // namespace lumi
