#pragma once

#include <cstdio>
#include <string>

namespace lumi {

/// What printf would print, of any length; empty where the format is wrong.
template <class... Values>
[[nodiscard]] std::string formatted(const char* format, Values... values) {
    const int length = std::snprintf(nullptr, 0, format, values...);
    if (length <= 0) return {};
    std::string text(static_cast<std::size_t>(length), '\0');
    std::snprintf(text.data(), text.size() + 1, format, values...);
    return text;
}

}  // namespace lumi
