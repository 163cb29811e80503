#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace lumi {

/// The number, or null where there is none.
[[nodiscard]] inline nlohmann::ordered_json optional_json(const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// The same read again.
[[nodiscard]] inline std::optional<double> optional_number(const nlohmann::ordered_json& value) {
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

}  // namespace lumi
