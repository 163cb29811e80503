#pragma once

#include "pipeline/commands/command_context.h"
#include "pipeline/commands/run_build.h"

namespace lumi {

/// `lumi build DATASET.toml`: builds and evaluates every scene; what fails does not stop the
/// others. Throws Error; E-DATASET-PARTIAL (kPartialResult) when scenes failed, after all is
/// written.
void run_dataset_build(const BuildRequest& request, const CommandContext& context);

}  // namespace lumi
