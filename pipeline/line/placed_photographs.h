#pragma once

#include <optional>
#include <vector>

#include "pipeline/workspace/stage_cache.h"

namespace lumi {

/// How many photographs a line found a place for.
struct PlacedPhotographs {
    int total = 0;
    int placed = 0;

    /// True below kEnoughPlacedShare: what was made shows a part of what was photographed.
    [[nodiscard]] bool is_partial() const;
};

/// As the pose stage tells; empty where it is not among the stages.
[[nodiscard]] std::optional<PlacedPhotographs> placed_photographs(
    const std::vector<FinishedStage>& stages);

}  // namespace lumi
