#pragma once

#include <optional>

#include "pipeline/line/placed_photographs.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// What was made stands, and is not what was asked for: throws Error (E-BUILD-PARTIAL) where too
/// few photographs found a place.
void refuse_partial(const std::optional<PlacedPhotographs>& photographs,
                    const WorkspaceLayout& layout);

}  // namespace lumi
