#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "meshing/planning/next_views.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// A plan with the names of the photographs that its indices stand for.
struct WorkspacePlan {
    CapturePlan plan;
    std::vector<std::string> view_names;
};

/// Plans from the poses in the workspace, those of held-out photographs included, and writes
/// plan/plan.json and plan/plan.svg. Throws Error (E-PLAN-NOPOSES, E-PLAN-ONESPOT).
[[nodiscard]] WorkspacePlan plan_workspace(const Workspace& workspace,
                                           const CapturePlanOptions& options);

[[nodiscard]] nlohmann::ordered_json plan_json(const WorkspacePlan& planned);
[[nodiscard]] std::string plan_text(const WorkspacePlan& planned);

}  // namespace lumi
