#pragma once

#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Writes report.html: one page without anything outside it, of what the workspace holds now
/// (verdict, photographs, poses, camera mesh, depth, held-out views, seconds, configuration).
void write_workspace_report(const WorkspaceLayout& workspace);

}  // namespace lumi
