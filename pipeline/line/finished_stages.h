#pragma once

#include <string>
#include <vector>

#include "pipeline/workspace/stage_cache.h"

namespace lumi {

/// What one of the finished stages wrote, where the name begins with `prefix`.
[[nodiscard]] std::vector<ContentEntry> outputs_of(const std::vector<FinishedStage>& finished,
                                                   const std::string& stage,
                                                   const std::string& prefix);

/// The facts of all finished stages by their names, as one JSON object.
[[nodiscard]] std::string facts_of(const std::vector<FinishedStage>& finished);

}  // namespace lumi
