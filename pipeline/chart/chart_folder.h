#pragma once

#include "pipeline/workspace/work_folder.h"

namespace lumi {

/// Takes the folder that a sweep, or how time and memory grow, is measured in. Throws Error as
/// WorkFolder does.
[[nodiscard]] WorkFolder take_chart_folder(const std::filesystem::path& folder);

}  // namespace lumi
