#pragma once

#include <map>
#include <string>

namespace lumi {

/// What each key of a configuration does and which values it takes, in one line, by its dotted
/// name: "depth.model". Values are spelled as where a wrong one is refused.
[[nodiscard]] const std::map<std::string, std::string>& key_meanings();

/// A resolved configuration (BuildConfig::movable_toml) with what each key means as a comment
/// behind its line, or above it where its value takes several. It says the same otherwise.
[[nodiscard]] std::string explained_configuration(const std::string& resolved_toml);

}  // namespace lumi
