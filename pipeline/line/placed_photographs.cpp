#include "pipeline/line/placed_photographs.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calib/poses/pose_stage.h"

namespace lumi {

bool PlacedPhotographs::is_partial() const { return placed < kEnoughPlacedShare * total; }

std::optional<PlacedPhotographs> placed_photographs(const std::vector<FinishedStage>& stages) {
    const auto poses = std::find_if(stages.begin(), stages.end(),
                                    [](const auto& stage) { return stage.name == "poses"; });
    if (poses == stages.end()) return std::nullopt;
    const auto facts = nlohmann::json::parse(poses->evidence.facts_json);
    return PlacedPhotographs{facts.value("photographs_total", 0),
                             facts.value("photographs_registered", 0)};
}

}  // namespace lumi
