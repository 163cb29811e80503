#pragma once

#include <nlohmann/json_fwd.hpp>

#include "calib/lens/lens_choice.h"

namespace lumi {

/// The forms that were compared, fewest free parameters first; errors that were not measured are
/// null.
[[nodiscard]] nlohmann::ordered_json lens_choice_json(const LensChoice& choice);

}  // namespace lumi
