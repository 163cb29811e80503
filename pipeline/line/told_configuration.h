#pragma once

#include <string>

#include "pipeline/config/build_config.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Over all that a configuration tells the stages, and what it holds out: the same for two that
/// make the same package of the same files.
[[nodiscard]] std::string configuration_sha256(const BuildConfig& config);

/// Keeps the configuration as config.toml of the workspace, with what each key means
/// (explained_configuration).
void write_configuration(const Workspace& workspace, const BuildConfig& config);

}  // namespace lumi
