#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lumi {

/// A lens of the poses stage: its parameters with what they may be off by, and what it was compared
/// with.
[[nodiscard]] std::string lens_table(const nlohmann::ordered_json& lens);

/// What the pose of each photograph may be off by; "" when that is not known.
[[nodiscard]] std::string pose_uncertainty_table(const nlohmann::ordered_json& poses);

}  // namespace lumi
