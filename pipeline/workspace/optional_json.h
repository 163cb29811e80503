#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace lumi {

/// The number, or null where there is none.
[[nodiscard]] inline nlohmann::ordered_json optional_json(const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace lumi
