#pragma once

#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Writes report.html: one page without anything outside it, of what the workspace holds now
/// (sections.h): pictures first, tables folded.
void write_workspace_report(const WorkspaceLayout& workspace);

}  // namespace lumi
