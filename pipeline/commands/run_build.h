#pragma once

#include <filesystem>
#include <string>

#include "pipeline/commands/command_context.h"

namespace lumi {

/// What the command line says about a build.
struct BuildRequest {
    std::filesystem::path config;     ///< A configuration file or a folder of photographs.
    std::filesystem::path workspace;  ///< Empty: as the configuration says.
};

/// Runs the line up to `last_stage`, writes the report and prints what was made: the package's path
/// (or the stage's folder), with --json what stages.json says. Throws Error; E-BUILD-PARTIAL after
/// all that, where too few photographs were placed for a whole result.
void run_build(const BuildRequest& request, const std::string& last_stage,
               const CommandContext& context);

}  // namespace lumi
