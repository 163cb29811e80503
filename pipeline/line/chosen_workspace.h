#pragma once

#include <filesystem>

#include "pipeline/config/build_config.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Where to build a configuration: in the folder that the command line names or that the
/// configuration does, else in work/NAME. Throws Error (E-WORKSPACE-OTHER) where the folder holds
/// what was made of other photographs, whether or not these can be reached: two captures would take
/// each other's place. Photographs that were moved are no others while they are the same. A
/// configuration that names its folder has it.
[[nodiscard]] WorkspaceLayout layout_for(const std::filesystem::path& named_folder,
                                         const BuildConfig& config, int threads);

}  // namespace lumi
