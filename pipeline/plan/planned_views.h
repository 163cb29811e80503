#pragma once

#include <filesystem>
#include <vector>

#include "render/viewer/commands.h"

namespace lumi {

/// What `lumi plan` wrote into the workspace that the package lies in (plan/plan.json beside it),
/// for the window. None where nothing was planned. Throws Error (E-JSON-READ) for a damaged plan.
[[nodiscard]] std::vector<PlannedView> planned_views_beside(
    const std::filesystem::path& package_folder);

}  // namespace lumi
