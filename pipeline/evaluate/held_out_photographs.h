#pragma once

#include "calib/capture/posed_photographs.h"
#include "pipeline/stages/pack_stage.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// What the finished package of the workspace was made from. Throws Error (E-EVAL-NOPACKAGE,
/// E-EVAL-NOHOLDOUT).
[[nodiscard]] PackRecord finished_pack(const WorkspaceLayout& workspace);

/// All photographs with poses, as the package was made from them. Throws Error (E-EVAL-STALE:
/// stale_package.h).
[[nodiscard]] PosedPhotographs packed_photographs(const WorkspaceLayout& workspace,
                                                  const PackRecord& record, int threads);

/// The held-out ones among them. Throws Error (E-EVAL-NOPOSE) when there is none.
[[nodiscard]] PosedPhotographs held_out_photographs(const WorkspaceLayout& workspace,
                                                    const PackRecord& record, int threads);
/// The same for whoever needs the record for nothing else.
[[nodiscard]] PosedPhotographs held_out_photographs(const WorkspaceLayout& workspace, int threads);

}  // namespace lumi
