#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/workspace/content.h"

namespace lumi {

/// The name of a stage's marker in its folder.
inline constexpr const char* kDoneMarkerName = "done.json";

/// True when every output stands where it is named below the workspace, with its content.
[[nodiscard]] bool are_unharmed(const std::filesystem::path& workspace_folder,
                                const std::vector<ContentEntry>& outputs, int threads);

/// The same of a stage that lies in `stage_folder`, whose outputs are named STAGE/...; false when
/// one is named otherwise.
[[nodiscard]] bool are_unharmed(const std::filesystem::path& stage_folder, const std::string& stage,
                                const std::vector<ContentEntry>& outputs, int threads);

}  // namespace lumi
