#include "calib/work/toml_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

namespace lumi {
namespace {

/// Whether six digits, as a reader likes them, say every number of a document.
bool has_short_numbers(const toml::node& node) {
    const auto is_short = [](const auto& entries, const auto& node_of) {
        return std::all_of(entries.begin(), entries.end(),
                           [&](const auto& entry) { return has_short_numbers(node_of(entry)); });
    };
    if (const toml::table* table = node.as_table()) {
        return is_short(*table,
                        [](const auto& entry) -> const toml::node& { return entry.second; });
    }
    if (const toml::array* array = node.as_array()) {
        return is_short(*array, [](const toml::node& entry) -> const toml::node& { return entry; });
    }
    const std::optional<double> number = node.value_exact<double>();
    if (!number || !std::isfinite(*number)) return true;
    constexpr int kDigits = 6;
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), *number,
                                   std::chars_format::general, kDigits);
    double again = 0;
    std::from_chars(digits.data(), end.ptr, again);
    return again == *number;
}

}  // namespace

std::string text_of(const toml::table& table) {
    std::ostringstream text;
    text << table << "\n";
    return text.str();
}

std::string readable_text_of(const toml::table& table) {
    if (!has_short_numbers(table)) return text_of(table);
    std::ostringstream text;
    text << toml::toml_formatter(table, toml::toml_formatter::default_flags |
                                            toml::format_flags::relaxed_float_precision)
         << "\n";
    return text.str();
}

}  // namespace lumi
