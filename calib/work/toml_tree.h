#pragma once

#include <toml++/toml.h>
#include <string>
#include <string_view>

#include "calib/work/config_section.h"

namespace lumi {

/// A document whose nodes know the line they stand in. Throws Error (E-CONFIG-SYNTAX) with line and
/// column.
[[nodiscard]] toml::table parsed_toml(std::string_view text, const std::string& name);

/// Where a node of the document `name` stands: "NAME:LINE"; of what was changed in it, which stands
/// in no file: "NAME with SETTING = LITERAL".
[[nodiscard]] std::string place_in_toml(const toml::node& node, const std::string& name);

/// Sets one value in the document `name`. All others keep their lines. Throws Error
/// (E-CONFIG-SYNTAX, E-CONFIG-VALUE when the setting lies below what is no table).
void change_toml(toml::table& document, const ConfigChange& change, const std::string& name);

}  // namespace lumi
