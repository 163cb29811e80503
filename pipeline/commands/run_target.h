#pragma once

#include <string>

#include "pipeline/commands/command_context.h"
#include "pipeline/commands/run_build.h"

namespace lumi {

/// `lumi build --target WISH`: measures the sweep of the configuration, builds what suits the wish,
/// measures it again and says what came of it. Throws Error; E-TARGET-MISSED (kPartialResult) when
/// the nearest is not enough.
void run_target(const BuildRequest& request, const std::string& wish,
                const CommandContext& context);

}  // namespace lumi
