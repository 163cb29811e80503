#pragma once

#include <toml++/toml.h>
#include <string>

namespace lumi {

/// The table as TOML, each number with all its digits.
[[nodiscard]] std::string text_of(const toml::table& table);

/// The same as people like to read it: 0.4 instead of 0.40000000000000002, where six digits say
/// every number of the table.
[[nodiscard]] std::string readable_text_of(const toml::table& table);

}  // namespace lumi
