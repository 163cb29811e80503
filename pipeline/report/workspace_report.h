#pragma once

#include <functional>

#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Writes report.html: one page without anything outside it, of what the workspace holds now
/// (sections.h): pictures first, tables folded. Throws Error (E-JSON-READ) where the files of the
/// workspace do not say what they should.
void write_workspace_report(const WorkspaceLayout& workspace);

/// Does work in a workspace and writes its report: also when something other than an interruption
/// ends the work and can be told of (error_of_exception.h), so that none stays there that tells of
/// a run before. The report tells what stages.json says of that end; what ends work after the
/// stages, such as an evaluation, is not in it. Throws what `work` and write_workspace_report do.
void work_and_report(const WorkspaceLayout& workspace, const std::function<void()>& work);

}  // namespace lumi
