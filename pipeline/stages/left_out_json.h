#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "calib/capture/posed_photographs.h"

namespace lumi {

/// Photographs that were left out, with code and reason, as a JSON array; and back. The reader
/// throws nlohmann::json::exception.
[[nodiscard]] nlohmann::ordered_json left_out_json(const std::vector<LeftOut>& left_out);
[[nodiscard]] std::vector<LeftOut> left_out_from(const nlohmann::ordered_json& json);

}  // namespace lumi
