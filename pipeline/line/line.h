#pragma once

#include <string>
#include <vector>

#include "pipeline/config/build_config.h"
#include "pipeline/workspace/stage_cache.h"

namespace lumi {

/// The stages in their order: ingest, poses, mesh, depth, pack. (Where the configuration names
/// photographs of a board, `calibrate` comes before the poses.)
[[nodiscard]] const std::vector<std::string>& stages_of_line();

/// Brings the line up to date, from photographs to `last_stage`, and keeps config.toml and
/// stages.json of the workspace. What is up to date is not made again. Throws Error; what was
/// finished before stays, and stages.json says what failed. With a store, workspaces share stages.
[[nodiscard]] std::vector<FinishedStage> run_line(const BuildConfig& config,
                                                  const Workspace& workspace,
                                                  const std::string& last_stage, int threads,
                                                  Progress& progress, StageStore* store = nullptr);

/// Where the workspace of a configuration lies, unless the command line says otherwise.
[[nodiscard]] WorkspaceLayout workspace_of(const BuildConfig& config);

}  // namespace lumi
