#pragma once

#include <filesystem>
#include <vector>

#include "render/viewer/commands.h"

namespace lumi {

/// The held-out photographs of the workspace that the package lies in, for the window. None where
/// it lies in no workspace, or nothing was held out. Throws what held_out_photographs throws, and
/// Error for a photograph that cannot be read.
[[nodiscard]] std::vector<HeldOutView> held_out_views_beside(
    const std::filesystem::path& package_folder);

}  // namespace lumi
