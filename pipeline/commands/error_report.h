#pragma once

#include <functional>

#include "pipeline/commands/command_context.h"

namespace lumi {

/// Runs `work` and prints what ends it on stderr (`error E-CODE: what`, then advice). With --json,
/// prints one object on stdout, whatever happens: the result that `work` left in the context, and
/// under "error" what ended it. Returns the exit code (design: 0, 2 to 7, 130; 1 for a bug of
/// lumi).
[[nodiscard]] int run_and_report_errors(const std::function<void()>& work,
                                        const CommandContext& context);

}  // namespace lumi
