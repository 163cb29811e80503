#pragma once

#include <string>

#include "pipeline/stages/pack_stage.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Why the package of a workspace is not the one that its configuration asks for, as far as its
/// record and the last run of the line tell; "" where it is.
[[nodiscard]] std::string why_package_is_stale(const WorkspaceLayout& workspace,
                                               const PackRecord& record, int threads);

}  // namespace lumi
