#pragma once

#include <vector>

#include "pipeline/evaluate/evaluation.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Draws the held-out views of a finished workspace from its package and writes evaluation/:
/// evaluation.json, NAME.png (photograph | rendering | error) for the first mode and
/// NAME.MODE.png for the others. The folder appears whole or not at all.
///
/// Throws Error: E-EVAL-NOPACKAGE, E-EVAL-NOHOLDOUT, E-EVAL-NOPOSE (no held-out photograph has a
/// pose), E-EVAL-STALE (the poses are not those the package was made from), E-PACKAGE-..., E-GL-...
Evaluation evaluate_workspace(const Workspace& workspace, const std::vector<RenderMode>& modes,
                              int threads, Progress& progress);

}  // namespace lumi
