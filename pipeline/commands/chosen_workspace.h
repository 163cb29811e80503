#pragma once

#include <filesystem>

#include "pipeline/config/build_config.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Where to build a configuration: in the folder that the command line names or that the
/// configuration does, else in work/NAME. Throws Error (E-WORKSPACE-OTHER) where nobody named a
/// folder and work/NAME holds what was made of other photographs, which are still there: two
/// captures of one name would take each other's place.
[[nodiscard]] WorkspaceLayout layout_for(const std::filesystem::path& named_folder,
                                         const BuildConfig& config, int threads);

}  // namespace lumi
