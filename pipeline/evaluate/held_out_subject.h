#pragma once

#include "pipeline/evaluate/evaluation.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// The options with the subject of held-out photographs, by what depth of this workspace went by:
/// the masks that were drawn over them, or the colour of the plain background that the other
/// photographs have, looked for in the held-out ones at the size of the depth maps. Unchanged where
/// depth took every pixel for the scene's.
[[nodiscard]] EvaluationOptions judging_subject(EvaluationOptions options,
                                                const WorkspaceLayout& workspace);

}  // namespace lumi
