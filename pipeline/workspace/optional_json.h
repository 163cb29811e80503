#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace lumi {

/// The number, or null where there is none.
[[nodiscard]] inline nlohmann::ordered_json optional_json(const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// The number in JSON, or none where it is null or not there.
[[nodiscard]] inline std::optional<double> optional_number(const nlohmann::ordered_json& object,
                                                           const char* key) {
    const auto found = object.find(key);
    if (found == object.end() || found->is_null()) return std::nullopt;
    return found->get<double>();
}

}  // namespace lumi
