#pragma once

#include <string>

#include "pipeline/evaluate/evaluation.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Draws the held-out views of a finished workspace from its package and writes evaluation/:
/// evaluation.json, NAME.png (photograph | rendering | error), NAME.flip.png and NAME.ghost.png
/// (heat maps) for the first mode, NAME.MODE.png for the others and NAME.METHOD.png for rivals. The
/// folder appears whole or not at all. `code_version` is that of "evaluate" (line/code_version.h),
/// which the file names.
///
/// Throws Error: E-EVAL-... (held_out_photographs.h), E-PACKAGE-..., E-GL-...
Evaluation evaluate_workspace(const Workspace& workspace, const EvaluationOptions& options,
                              const std::string& code_version, int threads, Progress& progress);

}  // namespace lumi
