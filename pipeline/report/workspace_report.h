#pragma once

#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Writes report.html: one page without anything outside it, of what the workspace holds now
/// (sections.h): pictures first, tables folded. Throws Error (E-JSON-READ) where the files of the
/// workspace do not say what they should.
void write_workspace_report(const WorkspaceLayout& workspace);

}  // namespace lumi
