#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "calib/ingest/ingest.h"

namespace lumi {

/// What was laid over photographs and taken out, as the report and the doctor tell it.
[[nodiscard]] nlohmann::ordered_json overlays_json(const std::vector<RemovedOverlay>& overlays);

}  // namespace lumi
